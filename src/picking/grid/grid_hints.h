#pragma once

#include "evolution/individual/individual.h"

#include <cstddef>
#include <optional>
#include <span>

namespace cambrian {

// Cells worth a badge; none if nothing is special. Hints, not scores (picking/README.md 1).
struct GridHints {
    std::optional<std::size_t> fastest;  // came furthest from where it started
    std::optional<std::size_t> highest;  // is the tallest, settled
    std::optional<std::size_t> oddest;   // is on average the most different from the others
};

GridHints grid_hints(std::span<const IndividualPtr> creatures);

}  // namespace cambrian
