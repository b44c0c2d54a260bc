#include "preserve/bodies/swept_bounds.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cambrian {
namespace {

// Returns the distance along the axis of either on which the two are farthest apart.
double gap_along_axes(const Rectangle& a, const Rectangle& b) {
    const Vec3 apart = b.center - a.center;
    double gap = -std::numeric_limits<double>::infinity();
    for (const Vec3& axis : {a.axis, a.across(), b.axis, b.across()}) {
        const double reach = half_projection(a, axis) + half_projection(b, axis);
        gap = std::max(gap, std::fabs(apart.dot(axis)) - reach);
    }
    return gap;
}

}  // namespace

void find_parts(const BodyView& body, SweptBounds& extent) {
    extent.parts.resize(body.part_count());
    extent.boxes.resize(body.part_count());
    for (std::size_t i = 0; i < extent.parts.size(); ++i) {
        extent.parts[i] = rectangle_of(body, i, body.part_half_extents(i));
        extent.boxes[i] = bounds_of(extent.parts[i]);
    }
}

void move(SweptBounds& extent, const Vec3& shift) {
    for (Rectangle& part : extent.parts)
        part = moved(part, shift);
    for (Bounds& box : extent.boxes)
        box = moved(box, shift);
}

const SweptBounds& seen(const SweptBounds& extent, const Vec3& shift, SweptBounds& memory) {
    if (shift == Vec3::Zero()) return extent;
    memory = extent;
    move(memory, shift);
    return memory;
}

Bounds grown(const Bounds& bounds, double growth) {
    const Vec3 by(growth, growth, 0.0);
    return {bounds.low - by, bounds.high + by};
}

double gap_between(const Bounds& a, const Bounds& b) {
    const double x = std::max(a.low.x() - b.high.x(), b.low.x() - a.high.x());
    const double y = std::max(a.low.y() - b.high.y(), b.low.y() - a.high.y());
    return std::max(x, y);
}

double gap_between_boxes(const SweptBounds& a, const SweptBounds& b) {
    double gap = std::numeric_limits<double>::infinity();
    for (const Bounds& first : a.boxes) {
        for (const Bounds& second : b.boxes)
            gap = std::min(gap, gap_between(first, second));
    }
    return gap;
}

double gap_between(const SweptBounds& a, const SweptBounds& b, double reach) {
    double gap = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < a.parts.size(); ++i) {
        for (std::size_t j = 0; j < b.parts.size(); ++j) {
            double found = gap_between(a.boxes[i], b.boxes[j]);
            if (found <= reach) found = std::max(found, gap_along_axes(a.parts[i], b.parts[j]));
            gap = std::min(gap, found);
        }
    }
    return gap;
}

bool has_left(const SweptBounds& before, const SweptBounds& after) {
    for (std::size_t i = 0; i < before.parts.size(); ++i) {
        const auto corners = corners_of(after.parts[i]);
        const auto from = corners_of(before.parts[i]);
        for (std::size_t corner = 0; corner < corners.size(); ++corner) {
            const double square = (corners[corner] - from[corner]).squaredNorm();
            if (!(square <= before.growth * before.growth)) return true;
        }
    }
    return false;
}

}  // namespace cambrian
