#pragma once

// All kinds the program knows, as the application fills them.

#include "app/builtin_kinds.h"

namespace cambrian::test {

inline const EvolutionKinds& kinds() {
    static const EvolutionKinds all = builtin_kinds();
    return all;
}

}  // namespace cambrian::test
