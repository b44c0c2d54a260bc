#pragma once

// A breeding method, which makes one child of one or two parents, before mutation
// (breeding/README.md 6).

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
    double default_share = 0.0;  // share of a generation's offspring
    bool heritable = true;       // whether genes may name it
    // The parents are valid and are not changed; the child is valid. Methods of one parent get it
    // as `second` too.
    Genome (*breed)(const Genome& first, const Genome& second, const KindCatalog& catalog,
                    RandomStream& stream) = nullptr;
};

using BreedingRegistry = Registry<BreedingKind>;

BreedingRegistry builtin_breeding();

// Returns KindCatalog::reproductions for these methods. Digests of genes count the heritable ones
// in the order of registration, so new ones are added at the end.
std::vector<std::string> reproductions_of(const BreedingRegistry& methods);

// Returns the first method of one parent, or the first of all if there is none.
const BreedingKind& single_parent_method(const BreedingRegistry& methods);

}  // namespace cambrian
