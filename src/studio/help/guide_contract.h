#pragma once

// The data of help pages and tour that panels see, and the requests they may make of them.

#include "studio/help/help_index.h"

#include <cstddef>
#include <string>
#include <variant>

namespace cambrian {

struct ToggleHelp {};
// Opens a help page by name: a file's stem in the help folder, or a built-in page of help_index.h.
struct ShowHelp {
    std::string page;
    std::size_t block = 0;  // of the page, which is scrolled into sight
};
// Goes to a step of the tour. A step beyond the last or below 0 ends it.
struct TurnTour {
    int step = 0;
};

using GuideRequest = std::variant<ToggleHelp, ShowHelp, TurnTour>;

struct GuideView {
    const HelpIndex* help = nullptr;
    bool help_shown = false;
    std::size_t help_block = 0;  // the block that was asked for last; 0 is the page itself
    unsigned help_asked = 0;     // number of ShowHelp requests so far
    int tour_step = -1;          // -1 while there is no tour
};

}  // namespace cambrian
