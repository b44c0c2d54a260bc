#pragma once

// The shape in which a part is drawn: that at rest, or stretched.

#include "math/elementary.h"
#include "world/body_plan.h"

#include <span>

namespace cambrian {

// Returns where a point of a part's rest shape is in the part's frame. `stretches` has one number
// for each part, or is empty for parts at rest.
inline Vec3 shown_point(const Vec3& point, std::span<const double> stretches, std::size_t part) {
    if (stretches.empty() || stretches[part] == 0.0) return point;
    const double growth = exponential(stretches[part]);
    return {growth * point.x(), point.y() / growth, point.z()};
}

inline Vec3 shown_half_extents(const BodyPlan& plan, std::span<const double> stretches,
                               std::size_t part) {
    return shown_point(plan.parts[part].half_extents, stretches, part);
}

}  // namespace cambrian
