#pragma once

// What panels may request of selection by hand; picking_view.h is what they see of it.

#include "picking/picking_command.h"
#include "studio/hand_picking/picking_view.h"

#include <cstddef>
#include <cstdint>
#include <variant>

namespace cambrian {

// Switches between automatic evolution and selection by hand.
struct ToggleHandPicking {};
// Goes back to automatic evolution, with the picks among the next generation's creatures, or with a
// new run that begins with them.
enum class PicksUse : std::uint8_t { kInject, kFound };
struct HandOverPicks {
    PicksUse use = PicksUse::kInject;
};
struct AskPicking {
    PickingCommand command;
};
struct FocusCell {
    std::size_t cell = 0;
};
// Displays a creature of the grid alone, until ShowGrid.
struct ShowCell {
    std::size_t cell = 0;
};
struct ShowGrid {};
struct ChangePickingOptions {
    PickingOptions options;
};

using PickingRequest = std::variant<ToggleHandPicking, HandOverPicks, AskPicking, FocusCell,
                                    ShowCell, ShowGrid, ChangePickingOptions>;

}  // namespace cambrian
