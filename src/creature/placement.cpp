#include "creature/placement.h"

#include "core/assert.h"
#include "math/angle.h"

#include <algorithm>
#include <cmath>

namespace cambrian {
namespace {

// Share of a face to which children can attach; corners stay free.
constexpr double kFaceShare = 0.9;
constexpr double kBurialShare = 0.7;
constexpr double kBurialAngle = to_radians(17.0);

Vec2 direction(double angle) {
    const SineCosine turn = sine_cosine(angle);
    return {turn.cosine, turn.sine};
}

Vec2 rotated(const Vec2& v, double angle) {
    const Vec2 x_axis = direction(angle);
    return {x_axis.x() * v.x() - x_axis.y() * v.y(), x_axis.y() * v.x() + x_axis.x() * v.y()};
}

PlannedPart box(const Vec2& center, double angle, double length, double width) {
    PlannedPart part;
    part.half_extents = {0.5 * length, 0.5 * width, 0.0};
    part.rest_pose = planar_pose(center.x(), center.y(), angle);
    part.rest_angle = angle;
    part.anchor_in_child = {-0.5 * length, 0.0, 0.0};
    return part;
}

Attachment attachment_of(const Vec2& point, double angle) {
    return {Vec3(point.x(), point.y(), 0.0), angle};
}

Attachment attachment(const EdgeGene& edge, const Vec3& parent_size) {
    const double parent_length = parent_size.x();
    const double parent_width = parent_size.y();
    const double walked = 4.0 * edge.position;
    const auto face = static_cast<Face>(std::min(static_cast<int>(walked), 3));
    const double along = (walked - static_cast<double>(face) - 0.5) * kFaceShare;
    const double half_length = 0.5 * parent_length;
    const double half_width = 0.5 * parent_width;
    switch (face) {
        case Face::kDistal:
            return attachment_of({half_length, along * parent_width}, edge.angle);
        case Face::kLeft:
            return attachment_of({along * parent_length, half_width}, 0.5 * kPi + edge.angle);
        case Face::kProximal:
            return attachment_of({-half_length, along * parent_width}, kPi + edge.angle);
        case Face::kRight:
        case Face::kFront:
        case Face::kBack:
            break;
    }
    return attachment_of({along * parent_length, -half_width}, -0.5 * kPi + edge.angle);
}

Attachment mirrored(const Attachment& original, MirrorAxis axis) {
    const Vec3& p = original.point;
    if (axis == MirrorAxis::kAlong) return attachment_of({p.x(), -p.y()}, -original.angle);
    return attachment_of({-p.x(), p.y()}, kPi - original.angle);
}

Mirror flipped(const Mirror& mirror, MirrorAxis /*axis*/) {
    return {-mirror.across, mirror.depth};
}

PlannedPart place_root(const Vec3& size, const Genome& genome, bool mirrored) {
    const double angle = mirrored ? kPi - genome.root_angle : genome.root_angle;
    return box(Vec2::Zero(), angle, size.x(), size.y());
}

PlannedPart place_child(const PlannedPart& parent, const Mirror& parent_mirror,
                        const Attachment& attachment, const Vec3& size) {
    const int side = parent_mirror.across;
    CAMBRIAN_TICK_ASSERT(side == 1 || side == -1, "a handedness");
    const double length = size.x();
    const Vec2 local(attachment.point.x(), side * attachment.point.y());
    const Vec2 anchor = parent.rest_pose.position.head<2>() + rotated(local, parent.rest_angle);
    const double angle = parent.rest_angle + side * attachment.angle;
    PlannedPart part = box(anchor + 0.5 * length * direction(angle), angle, length, size.y());
    part.anchor_in_parent = {local.x(), local.y(), 0.0};
    return part;
}

bool is_buried(const PlannedPart& part, const PlannedPart& other) {
    const Vec2 offset = (part.rest_pose.position - other.rest_pose.position).head<2>();
    const Vec2 local = rotated(offset, -other.rest_angle);
    const double tilt = sine(part.rest_angle - other.rest_angle);
    return std::fabs(local.x()) < kBurialShare * other.half_extents.x() &&
           std::fabs(local.y()) < kBurialShare * other.half_extents.y() &&
           std::fabs(tilt) < sine(kBurialAngle);
}

}  // namespace

const Placement& planar_placement() {
    static const Placement placement = {attachment, mirrored,    flipped,
                                        place_root, place_child, is_buried};
    return placement;
}

}  // namespace cambrian
