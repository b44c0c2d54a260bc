#pragma once

// The search of the command palette.

#include "studio/frame/frame_context.h"
#include "studio/frame/requests.h"
#include "studio/help/help_places.h"

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cambrian {

// Returns how well a title, or else a text, contains all words in this order, in upper or lower
// case; nothing if neither does. 0: the title begins with them; 1: they begin words of the title;
// 2: they are in the title; 3: the text has them side by side; 4: they begin words of the text; 5:
// they are in the text.
std::optional<int> match_rank(std::string_view words, std::string_view title,
                              std::string_view text);

struct PaletteLine {
    std::string title;  // "Grip (friction)"
    std::string what;   // "Environment, 0.8"
    std::string kind;   // keys of an action, or "setting" or "help"
    bool enabled = true;
    std::function<void(const FrameContext& frame, Requests& out)> go;
};

// Returns actions, settings and places of the help that match the words, best first; of equal ones,
// actions before settings before help, each in the order of their table. Without words it returns
// all actions.
std::vector<PaletteLine> palette_lines(std::string_view words, const FrameContext& frame,
                                       const std::vector<HelpPlace>& help);

}  // namespace cambrian
