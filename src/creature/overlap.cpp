#include "creature/overlap.h"

#include "math/elementary.h"

#include <cmath>

namespace cambrian {
namespace {

constexpr double kTouchingGap = 1e-9;  // m

// Returns whether an axis of the first box separates the two boxes.
bool apart_along_axes(const PlannedPart& a, const PlannedPart& b) {
    const SineCosine turn = sine_cosine(a.rest_angle);
    const SineCosine other = sine_cosine(b.rest_angle);
    const double along = std::fabs(turn.cosine * other.cosine + turn.sine * other.sine);
    const double across = std::fabs(turn.cosine * other.sine - turn.sine * other.cosine);
    const Vec3 way = b.rest_pose.position - a.rest_pose.position;
    const double x = std::fabs(turn.cosine * way.x() + turn.sine * way.y());
    const double y = std::fabs(turn.cosine * way.y() - turn.sine * way.x());
    const Vec3& half = b.half_extents;
    const double gap_x = x - a.half_extents.x() - along * half.x() - across * half.y();
    const double gap_y = y - a.half_extents.y() - across * half.x() - along * half.y();
    return std::fmax(gap_x, gap_y) > -kTouchingGap;
}

bool tied(const BodyPlan& plan, std::size_t a, std::size_t b) {
    return plan.parts[a].parent == static_cast<int>(b) ||
           plan.parts[b].parent == static_cast<int>(a);
}

}  // namespace

bool overlaps_itself(const BodyPlan& plan) {
    for (std::size_t a = 0; a < plan.parts.size(); ++a) {
        for (std::size_t b = a + 1; b < plan.parts.size(); ++b) {
            if (tied(plan, a, b)) continue;
            const bool apart = apart_along_axes(plan.parts[a], plan.parts[b]) ||
                               apart_along_axes(plan.parts[b], plan.parts[a]);
            if (!apart) return true;
        }
    }
    return false;
}

}  // namespace cambrian
