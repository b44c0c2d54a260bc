#pragma once

#include "creature/phenotype.h"

#include <cstddef>

namespace cambrian {

// The highlighted items: one part of the body, all parts grown from one gene node, and the gene
// node chosen in the inspector. -1 means none.
struct Highlight {
    int part = -1;
    int node = -1;
    int chosen = -1;

    bool covers(std::size_t index, const BodyPart& body_part) const {
        const auto grown_from = static_cast<int>(body_part.node);
        return static_cast<int>(index) == part || grown_from == node || grown_from == chosen;
    }
    // Replaces each member that the other highlight sets.
    void join(const Highlight& other) {
        if (other.part >= 0) part = other.part;
        if (other.node >= 0) node = other.node;
        if (other.chosen >= 0) chosen = other.chosen;
    }
    friend bool operator==(const Highlight&, const Highlight&) = default;
};

}  // namespace cambrian
