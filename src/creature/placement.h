#pragma once

// The planar geometry of attaching a part to another (creature/README.md 2, 4). A version in three
// dimensions would replace only this file of morphogenesis.

#include "genome/gene.h"
#include "math/types.h"
#include "world/body_plan.h"

namespace cambrian {

// The point and direction at which a child is attached, in the parent's frame before mirroring.
struct Attachment {
    Vec2 point = Vec2::Zero();  // m
    double angle = 0.0;         // rad, direction of the child's long axis
};

// Returns the attachment on the outline of a parent of the given size (m).
Attachment attachment(const EdgeGene& edge, double parent_length, double parent_width);

// Returns the attachment of the mirror partner.
Attachment mirrored(const Attachment& original, MirrorAxis axis);

// Returns the root of the given size (m), centred at the origin, with its long axis at the angle
// (rad).
PlannedPart place_root(double length, double width, double angle);

// Returns a child of the given size at rest, with poses and anchors. The handedness is the
// parent's.
PlannedPart place_child(const PlannedPart& parent, int parent_handedness,
                        const Attachment& attachment, double length, double width);

// Returns whether a part lies inside another and almost parallel to it: its centre is within the
// middle 70 % in both directions, and the long axes differ by less than 17 degrees.
bool is_buried(const PlannedPart& part, const PlannedPart& other);

}  // namespace cambrian
