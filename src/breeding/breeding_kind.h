#pragma once

// A way to make one child of one or two parents (breeding/README.md 6), before mutation.

#include "core/random.h"
#include "core/registry.h"
#include "genome/genome.h"

#include <string>
#include <vector>

namespace cambrian {

struct BreedingKind {
    std::string id;
    std::string label;
    int parents = 1;             // 1 or 2
    double default_share = 0.0;  // of a generation's offspring
    bool heritable = true;       // whether genes may name it, where creatures choose
    // The parents are valid and unchanged; the child is valid. second is the first parent again for
    // one-parent methods.
    Genome (*breed)(const Genome& first, const Genome& second, const KindCatalog& catalog,
                    RandomStream& stream) = nullptr;
};

using BreedingRegistry = Registry<BreedingKind>;

BreedingRegistry builtin_breeding();

// What KindCatalog::reproductions is with these methods. Digests of genes count the heritable ones
// in the order of registration, so new ones go to the end.
std::vector<std::string> reproductions_of(const BreedingRegistry& methods);

// The first method of one parent, or the first of all if there is none.
const BreedingKind& single_parent_method(const BreedingRegistry& methods);

}  // namespace cambrian
