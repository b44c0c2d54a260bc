#pragma once

// The company of a run, as panels see it, and the requests that they may make of it.

#include "studio/coach/founder_crowd.h"

#include <cstddef>
#include <variant>

namespace cambrian {

// Describes another creature of the crowd in the inspector.
struct ChooseFounder {
    std::size_t place = 0;
};

// Shows or hides what can be changed when evolution is stuck.
struct ShowSuggestions {
    bool shown = true;
};

using CoachRequest = std::variant<ChooseFounder, ShowSuggestions>;

struct CoachView {
    const FounderCrowd* founders = nullptr;  // null unless they are displayed
    std::size_t founder = 0;                 // place of the one that the inspector describes
    bool suggestions = false;                // whether the suggestions are displayed
};

}  // namespace cambrian
