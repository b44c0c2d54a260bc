#pragma once

// A breeding method, which makes one child of one or two parents, before mutation
// (breeding/README.md 6).

#include "core/random.h"
#include "core/registry.h"
#include "genome/genome.h"

#include <string>

namespace cambrian {

struct BreedingKind {
    std::string id;  // "asexual", "crossover", "grafting"
    std::string label;
    int parents = 1;             // 1 or 2
    double default_share = 0.0;  // share of a generation's offspring
    // The parents are valid and are not changed; the child is valid. Methods of one parent get it
    // as `second` too.
    Genome (*breed)(const Genome& first, const Genome& second, const KindCatalog& catalog,
                    RandomStream& stream) = nullptr;
};

using BreedingRegistry = Registry<BreedingKind>;

BreedingRegistry builtin_breeding();

}  // namespace cambrian
