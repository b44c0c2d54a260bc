#pragma once

// The line of descent of the displayed creature.

#include "evolution/engine/snapshot.h"
#include "studio/playback/exhibit.h"

#include <optional>
#include <vector>

namespace cambrian {

struct AncestryStep {
    IndividualPtr individual;
    std::optional<double> gained;  // fitness gained over its parent, if both were evaluated
};

// Returns the line from the creature itself to its oldest known ancestor.
std::vector<AncestryStep> ancestry_of(const Exhibit& exhibit);

// Returns step `index` (from 1) of the line of `head` as an exhibit. If the snapshot's journal has
// the settings that evaluated the ancestor, the exhibit has these. Otherwise it is unscored and has
// the settings of `head`.
Exhibit ancestor_exhibit(const Exhibit& head, const std::vector<AncestryStep>& line,
                         std::size_t index, const EvolutionSnapshot& snapshot);

}  // namespace cambrian
