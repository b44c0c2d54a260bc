#include "sketch/pairs.h"

namespace cambrian {

bool is_on_both_sides(const BodySketch& sketch, std::size_t part) {
    for (; part > 0; part = sketch.parent_of(part)) {
        if (sketch.origins[part].partner) return true;
    }
    return false;
}

}  // namespace cambrian
