#pragma once

// The items that can be dragged between the picking grid and the shelf.

#include "picking/picking_command.h"

#include <cstddef>
#include <optional>

namespace cambrian {

// Makes the last item draggable: a creature of the grid, or a place of the shelf.
void drag_cell(const PinCreature& creature);
void drag_pin(std::size_t place);

// Returns what was dropped on the last item, if anything.
std::optional<PinCreature> dropped_cell();
std::optional<std::size_t> dropped_pin();

}  // namespace cambrian
