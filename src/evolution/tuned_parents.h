#pragma once

#include "core/random.h"
#include "evolution/individual/individual.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace cambrian {

// Chooses which children of a generation are tuned copies, and of whom (evolution/README.md 6).
// Each child is one with probability `share`. Its parent is the best survivor of a founder's line,
// drawn in proportion to 0.1 + (f - f_S) / (f_1 - f_S), where f_1 is the fitness of the best and
// f_S that of the worst survivor. Returns an index into `ranked` for each child that is tuned, and
// nothing for the others. `survivors` are ascending indices and not empty. Draws no random number
// if `share` is 0.
std::vector<std::optional<std::size_t>> draw_tuned_parents(std::span<const IndividualPtr> ranked,
                                                           std::span<const std::size_t> survivors,
                                                           std::size_t children, double share,
                                                           RandomStream& stream);

}  // namespace cambrian
