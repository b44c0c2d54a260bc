#pragma once

#include "creature/phenotype.h"

#include <cstddef>

namespace cambrian {

// What the mouse points at, wherever it does: one part of the body, or all parts grown from one
// gene node. -1 is none.
struct Highlight {
    int part = -1;
    int node = -1;

    bool covers(std::size_t index, const BodyPart& body_part) const {
        return static_cast<int>(index) == part || static_cast<int>(body_part.node) == node;
    }
    friend bool operator==(const Highlight&, const Highlight&) = default;
};

}  // namespace cambrian
