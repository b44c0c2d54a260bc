#pragma once

#include "evolution/individual/individual.h"

#include <cstddef>
#include <optional>
#include <span>

namespace cambrian {

// Cells that get a badge; empty if no creature that completed its trial has that distinction. Hints
// are not scores (picking/README.md 1).
struct GridHints {
    std::optional<std::size_t> fastest;  // creature that moved the greatest distance from its start
    std::optional<std::size_t> highest;  // tallest creature after settling
    std::optional<std::size_t> oddest;   // creature with the greatest mean distance to the others
};

GridHints grid_hints(std::span<const IndividualPtr> creatures);

}  // namespace cambrian
