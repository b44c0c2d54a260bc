#pragma once

// A way to make one child of one or two parents (breeding/README.md 6), before mutation.

#include "core/random.h"
#include "core/registry.h"
#include "genome/genome.h"

#include <string>

namespace cambrian {

struct BreedingKind {
    std::string id;  // "asexual", "crossover", "grafting"
    std::string label;
    int parents = 1;             // 1 or 2
    double default_share = 0.0;  // of a generation's offspring
    // The parents are valid and unchanged; the child is valid. second is the first parent again for
    // one-parent methods.
    Genome (*breed)(const Genome& first, const Genome& second, const KindCatalog& catalog,
                    RandomStream& stream) = nullptr;
};

using BreedingRegistry = Registry<BreedingKind>;

BreedingRegistry builtin_breeding();

}  // namespace cambrian
