#pragma once

// The tour of the window for a first visit: a few deeds, each of which leads to the next.

#include "pictures/scene/character.h"
#include "world/environment.h"

#include <cstddef>
#include <span>

namespace cambrian {

// The user's deeds so far, as far as the tour asks for them.
struct Deeds {
    bool evolving = false;
    std::size_t generations = 0;  // finished ones of the open experiment
    Environment environment;      // in the settings as edited
    LookMode look = LookMode::kLife;
    unsigned saves = 0;  // number of files saved
};

struct TourStep {
    const char* place;  // name given to note_place(); it is outlined
    const char* over;   // the same, of the place that the card covers; null: beside `place`
    const char* title;
    const char* text;
    // Returns whether the step's deed was done since the step was shown.
    bool (*done)(const Deeds& before, const Deeds& now);
};

std::span<const TourStep> tour_steps();

}  // namespace cambrian
