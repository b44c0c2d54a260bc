#include "support/mirror_image.h"

#include "math/elementary.h"

#include <utility>

namespace cambrian {

BodyPlan mirror_image(BodyPlan plan, Flip flip) {
    const auto flipped = [flip](const Vec3& anchor) {
        return flip == Flip::kLength ? Vec3(-anchor.x(), anchor.y(), anchor.z())
                                     : Vec3(anchor.x(), -anchor.y(), anchor.z());
    };
    for (PlannedPart& part : plan.parts) {
        Vec3 position = part.rest_pose.position;
        (flip == Flip::kUpsideDown ? position.y() : position.x()) *= -1.0;
        part.rest_angle = (flip == Flip::kWidth ? kPi : 0.0) - part.rest_angle;
        part.rest_pose = planar_pose(position.x(), position.y(), part.rest_angle);
        part.anchor_in_parent = flipped(part.anchor_in_parent);
        part.anchor_in_child = flipped(part.anchor_in_child);
        std::swap(part.limit_low, part.limit_high);
        part.limit_low = -part.limit_low;
        part.limit_high = -part.limit_high;
    }
    return plan;
}

}  // namespace cambrian
