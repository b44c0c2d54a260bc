#pragma once

// The line of descent of a creature shown.

#include "evolution/engine/snapshot.h"
#include "studio/playback/exhibit.h"

#include <optional>
#include <vector>

namespace cambrian {

struct AncestryStep {
    IndividualPtr individual;
    std::optional<double> gained;  // fitness, over its parent, where both were judged
};

// The creature itself first, the oldest ancestor known last.
std::vector<AncestryStep> ancestry_of(const Exhibit& exhibit);

// An ancestor to be shown: step `index` (from 1) of the line of `head`, in the world that
// judged it if the journal of its experiment is at hand, else, unscored, in that of `head`.
Exhibit ancestor_exhibit(const Exhibit& head, const std::vector<AncestryStep>& line,
                         std::size_t index, const EvolutionSnapshot& snapshot);

}  // namespace cambrian
