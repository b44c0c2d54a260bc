#pragma once

#include "genome/founder_settings.h"
#include "genome/genome.h"

#include <string>
#include <vector>

namespace cambrian {

// A kind that a genome uses although the settings allow it neither in random genomes nor in
// mutation.
struct DisabledKind {
    std::string place;  // place of its first use: "/nodes/1/joint"
    std::string what;   // "joint \"linear\""
};

// Returns such joints, functions, organs and sensor channels, each once, in the order of the
// genome.
std::vector<DisabledKind> disabled_kinds(const Genome& genome, const FounderSettings& settings,
                                         const KindCatalog& catalog);

}  // namespace cambrian
