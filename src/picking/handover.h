#pragma once

// The way from selection by hand back to automatic evolution.

#include "evolution/engine/command.h"
#include "evolution/individual/individual.h"

#include <span>
#include <vector>

namespace cambrian {

std::vector<GenomePtr> genomes_of(std::span<const IndividualPtr> creatures);

// Returns commands that put the picks into the next generation of a running experiment, in place of
// its worst creatures.
std::vector<EngineCommand> injection_of(std::span<const IndividualPtr> picks);

}  // namespace cambrian
