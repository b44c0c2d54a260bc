#pragma once

// The geometry of attaching a part to another, in the plane or in space (creature/README.md 2, 4,
// 10). Growth leaves all that depends on the number of dimensions to it and to mirrors.

#include "genome/genome.h"
#include "math/types.h"
#include "world/joint_kind.h"

namespace cambrian {

// The place and direction at which a child is attached, in the parent's frame before mirroring.
struct Attachment {
    Vec3 point = Vec3::Zero();  // m
    double angle = 0.0;         // rad, in the plane: direction of the child's long axis
    // In space: the child's attitude.
    Rotation attitude = Rotation::Identity();
};

// The mirror images and places of one space. Sizes are length, width and depth in m.
struct Placement {
    // Returns the attachment on a parent of the given size.
    Attachment (*attachment)(const EdgeGene& edge, const Vec3& parent_size) = nullptr;
    // Returns the attachment of the mirror partner.
    Attachment (*mirrored)(const Attachment& original, MirrorAxis axis) = nullptr;
    // Returns the mirror of the mirror partner.
    Mirror (*flipped)(const Mirror& mirror, MirrorAxis axis) = nullptr;
    // Returns the root, centred at the origin, in the attitude of its genes or its mirror image
    // from left to right.
    PlannedPart (*place_root)(const Vec3& size, const Genome& genome, bool mirrored) = nullptr;
    // Returns a child of the given size at rest, with poses and anchors. The mirror is
    // the parent's.
    PlannedPart (*place_child)(const PlannedPart& parent, const Mirror& parent_mirror,
                               const Attachment& attachment, const Vec3& size) = nullptr;
    // Returns whether a part lies inside another and almost parallel to it: its centre is within
    // the middle 70 % in all directions, and the long axes differ by less than 17 degrees.
    bool (*is_buried)(const PlannedPart& part, const PlannedPart& other) = nullptr;
};

const Placement& planar_placement();
const Placement& spatial_placement();

// Turns the start pose of a creature about the axis towards the viewer by `tilt`. In space it is
// turned about the vertical by `heading` before, so that it is tilted about a horizontal axis of
// any direction. Angles are in rad.
void turn_root(Genome& genome, double tilt, double heading);

}  // namespace cambrian
