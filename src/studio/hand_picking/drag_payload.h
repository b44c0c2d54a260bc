#pragma once

// What is dragged between the grid of selection by hand and its shelf.

#include "picking/picking_command.h"

#include <cstddef>
#include <optional>

namespace cambrian {

// The last item can be dragged: a creature of the grid, or a place of the shelf.
void drag_cell(const PinCreature& creature);
void drag_pin(std::size_t place);

// What was dropped on the last item.
std::optional<PinCreature> dropped_cell();
std::optional<std::size_t> dropped_pin();

}  // namespace cambrian
