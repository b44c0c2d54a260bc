#pragma once

// The requests that panels may make of selection by hand. The data they see is in picking_view.h.

#include "picking/picking_command.h"
#include "studio/hand_picking/picking_view.h"

#include <cstddef>
#include <cstdint>
#include <variant>

namespace cambrian {

// Switches between automatic evolution and selection by hand.
struct ToggleHandPicking {};
// Returns to automatic evolution. The picked creatures join the next generation or become the
// founders of a new run.
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
// Displays one creature of the grid until ShowGrid.
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
