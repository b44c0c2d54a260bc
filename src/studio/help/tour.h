#pragma once

// The first look round: a few places of the window, two sentences each.

#include <span>

namespace cambrian {

struct TourStep {
    const char* place;  // as noted by note_place
    const char* title;
    const char* text;
};

std::span<const TourStep> tour_steps();

}  // namespace cambrian
