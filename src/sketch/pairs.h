#pragma once

#include "sketch/body_sketch.h"

namespace cambrian {

// Whether a part is one of a mirror pair or grows from one, so that what grows from it is on both
// sides anyway.
bool is_on_both_sides(const BodySketch& sketch, std::size_t part);

}  // namespace cambrian
