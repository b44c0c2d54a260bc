#pragma once

// All kinds of the program, as the application registers them.

#include "app/builtin_kinds.h"

namespace cambrian::test {

inline const EvolutionKinds& kinds() {
    static const EvolutionKinds all = builtin_kinds();
    return all;
}

// Returns the kinds that a creature's growth and motion need.
inline const Kinds& creature_kinds() {
    return kinds().creature;
}

inline const EvolutionKinds& spatial_kinds() {
    static const EvolutionKinds all = builtin_kinds(3);
    return all;
}

inline const KindCatalog& kind_catalog() {
    return kinds().creature.catalog;
}

}  // namespace cambrian::test
