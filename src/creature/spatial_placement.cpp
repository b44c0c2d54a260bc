#include "creature/placement.h"
#include "math/angle.h"
#include "math/elementary.h"

#include <algorithm>
#include <cmath>

namespace cambrian {
namespace {

// As in the plane (placement.cpp).
constexpr double kOutlineShare = 0.9;
constexpr double kInnerShare = 0.7;
constexpr double kParallelAngle = to_radians(17.0);

Rotation turned_about(const Vec3& axis, double angle) {
    const SineCosine half = sine_cosine(0.5 * angle);
    return {half.cosine, half.sine * axis.x(), half.sine * axis.y(), half.sine * axis.z()};
}

// Returns the same turn with the axes of these signs reflected.
Rotation reflected(const Rotation& q, const Vec3& signs) {
    return {q.w(), signs.y() * signs.z() * q.x(), signs.x() * signs.z() * q.y(),
            signs.x() * signs.y() * q.z()};
}

Vec3 reflection_of(const Mirror& mirror) {
    return {1.0, static_cast<double>(mirror.across), static_cast<double>(mirror.depth)};
}

// A point of the parent's outline in its middle plane, and the direction out of it.
struct OutlinePoint {
    double x, y, angle;
};

OutlinePoint walk_outline(double position, const Vec3& size) {
    const double walked = 4.0 * position;
    const int face = std::min(static_cast<int>(walked), 3);
    const double along = (walked - face - 0.5) * kOutlineShare;
    switch (static_cast<Face>(face)) {
        case Face::kDistal:
            return {0.5 * size.x(), along * size.y(), 0.0};
        case Face::kLeft:
            return {along * size.x(), 0.5 * size.y(), 0.5 * kPi};
        case Face::kProximal:
            return {-0.5 * size.x(), along * size.y(), kPi};
        case Face::kRight:
        case Face::kFront:
        case Face::kBack:
            break;
    }
    return {along * size.x(), -0.5 * size.y(), -0.5 * kPi};
}

// The height lifts the point of the outline up to the edge and then moves it over the front or the
// back, so small steps reach every face.
Attachment solid_attachment(const EdgeGene& edge, const Vec3& size) {
    const OutlinePoint outline = walk_outline(edge.position, size);
    const double height = std::fabs(edge.height);
    const double side = edge.height < 0.0 ? -1.0 : 1.0;
    Attachment attachment;
    Rotation outward = turned_about(Vec3::UnitZ(), outline.angle);
    if (height <= 0.5) {
        attachment.point = {outline.x, outline.y, kOutlineShare * edge.height * size.z()};
    } else {
        const double inwards = 2.0 * (1.0 - height);
        attachment.point = {inwards * outline.x, inwards * outline.y, 0.5 * side * size.z()};
        outward = outward * turned_about(Vec3::UnitY(), -0.5 * kPi * side);
    }
    attachment.attitude = outward * turned_about(Vec3::UnitZ(), edge.angle) *
                          turned_about(Vec3::UnitY(), -edge.tilt) *
                          turned_about(Vec3::UnitX(), edge.roll);
    return attachment;
}

// The mirror image of a right-handed frame is left-handed; one of the child's own sides is
// reflected as well, so that it is a rotation again. The child's signs take that back.
Attachment solid_mirrored(const Attachment& original, MirrorAxis axis) {
    Attachment image = original;
    const Rotation& q = original.attitude;
    switch (axis) {
        case MirrorAxis::kAlong:
            image.point.y() = -image.point.y();
            image.attitude = reflected(q, {1.0, -1.0, 1.0});
            break;
        case MirrorAxis::kDepth:
            image.point.z() = -image.point.z();
            image.attitude = reflected(q, {1.0, 1.0, -1.0});
            break;
        case MirrorAxis::kAcross:
            image.point.x() = -image.point.x();
            // diag(-1, 1, 1) A diag(1, -1, 1) = half a turn about z, then the reflection in y.
            image.attitude = Rotation(0.0, 0.0, 0.0, 1.0) * reflected(q, {1.0, -1.0, 1.0});
            break;
    }
    return image;
}

Mirror solid_flipped(const Mirror& mirror, MirrorAxis axis) {
    return axis == MirrorAxis::kDepth ? Mirror{mirror.across, -mirror.depth}
                                      : Mirror{-mirror.across, mirror.depth};
}

PlannedPart solid(const Vec3& center, const Rotation& attitude, const Vec3& size) {
    PlannedPart part;
    part.half_extents = 0.5 * size;
    part.rest_pose = {center, attitude};
    part.anchor_in_child = {-0.5 * size.x(), 0.0, 0.0};
    return part;
}

Rotation root_attitude(const Genome& genome) {
    return turned_about(Vec3::UnitZ(), genome.root_angle) *
           turned_about(Vec3::UnitY(), -genome.root_tilt) *
           turned_about(Vec3::UnitX(), genome.root_roll);
}

PlannedPart place_solid_root(const Vec3& size, const Genome& genome, bool /*mirrored*/) {
    return solid(Vec3::Zero(), root_attitude(genome), size);
}

PlannedPart place_solid_child(const PlannedPart& parent, const Mirror& parent_mirror,
                              const Attachment& attachment, const Vec3& size) {
    const Vec3 signs = reflection_of(parent_mirror);
    const Vec3 anchor = signs.cwiseProduct(attachment.point);
    const Rotation attitude =
        (parent.rest_pose.orientation * reflected(attachment.attitude, signs)).normalized();
    const Vec3 center =
        transform(parent.rest_pose, anchor) + attitude * Vec3(0.5 * size.x(), 0.0, 0.0);
    PlannedPart part = solid(center, attitude, size);
    part.anchor_in_parent = anchor;
    return part;
}

bool is_solid_buried(const PlannedPart& part, const PlannedPart& other) {
    const Rotation inverse = other.rest_pose.orientation.conjugate();
    const Vec3 local = inverse * Vec3(part.rest_pose.position - other.rest_pose.position);
    const Vec3 along = inverse * (part.rest_pose.orientation * Vec3::UnitX());
    const double across = along.y() * along.y() + along.z() * along.z();
    const double most = sine(kParallelAngle);
    return (local.cwiseAbs() - kInnerShare * other.half_extents).maxCoeff() < 0.0 &&
           across < most * most;
}

}  // namespace

const Placement& spatial_placement() {
    static const Placement placement = {solid_attachment, solid_mirrored,    solid_flipped,
                                        place_solid_root, place_solid_child, is_solid_buried};
    return placement;
}

void turn_root(Genome& genome, double tilt, double heading) {
    if (genome.dimensions == 3) {
        const Rotation attitude = turned_about(Vec3::UnitY(), heading) * root_attitude(genome);
        const Vec3 along = attitude * Vec3::UnitX();
        const double flat = std::sqrt(along.x() * along.x() + along.y() * along.y());
        genome.root_angle = arc_tangent2(along.y(), along.x());
        genome.root_tilt = arc_tangent2(along.z(), flat);
        genome.root_roll = wrap_angle(
            arc_tangent2((attitude * Vec3::UnitY()).z(), (attitude * Vec3::UnitZ()).z()));
    }
    genome.root_angle = wrap_angle(genome.root_angle + tilt);
}

}  // namespace cambrian
