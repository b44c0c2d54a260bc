#pragma once

// The tour of the window for a first visit: a few places, with two sentences on each.

#include <span>

namespace cambrian {

struct TourStep {
    const char* place;  // name given to note_place()
    const char* title;
    const char* text;
};

std::span<const TourStep> tour_steps();

}  // namespace cambrian
