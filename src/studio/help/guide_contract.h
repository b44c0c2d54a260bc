#pragma once

// What panels see of help and tour and what they may request of them.

#include "studio/help/help_book.h"

#include <string>
#include <variant>

namespace cambrian {

struct ToggleHelp {};
// Opens a page by its name: the file's in the help folder, or one of help_book.h.
struct ShowHelp {
    std::string page;
};
// Goes to a step of the tour; a step beyond the last, or below 0, ends it.
struct TurnTour {
    int step = 0;
};

using GuideRequest = std::variant<ToggleHelp, ShowHelp, TurnTour>;

struct GuideView {
    const HelpBook* help = nullptr;
    bool help_shown = false;
    int tour_step = -1;  // negative outside the tour
};

}  // namespace cambrian
