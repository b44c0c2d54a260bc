#pragma once

// All kinds the program knows, as the application fills them.

#include "app/builtin_kinds.h"

namespace cambrian::test {

inline const EvolutionKinds& kinds() {
    static const EvolutionKinds all = builtin_kinds();
    return all;
}

// What grows and moves a creature.
inline const Kinds& creature_kinds() {
    return kinds().creature;
}

inline const KindCatalog& kind_catalog() {
    return kinds().creature.catalog;
}

}  // namespace cambrian::test
