#pragma once

#include "genome/founder_settings.h"
#include "genome/genome.h"

#include <string>
#include <vector>

namespace cambrian {

// A kind a genome uses although the settings let neither random genomes nor mutation use it.
struct DisabledKind {
    std::string place;  // of its first use: "/nodes/1/joint"
    std::string what;   // "joint \"linear\""
};

// Joints, functions and sensor channels, each once, in the order of the genome.
std::vector<DisabledKind> disabled_kinds(const Genome& genome, const FounderSettings& settings,
                                         const KindCatalog& catalog);

}  // namespace cambrian
