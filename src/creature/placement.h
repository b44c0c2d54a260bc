#pragma once

// The planar geometry of growing one part from another (creature/README.md 2, 4): the only file of
// morphogenesis that a body of three dimensions replaces.

#include "genome/gene.h"
#include "math/types.h"
#include "world/body_plan.h"

namespace cambrian {

// Where and in which direction a child leaves its parent, in the parent's frame before handedness.
struct Attachment {
    Vec2 point = Vec2::Zero();  // m
    double angle = 0.0;         // rad, of the child's long axis
};

// On the outline of a parent of the given size (m).
Attachment attachment(const EdgeGene& edge, double parent_length, double parent_width);

// Of the mirror partner.
Attachment mirrored(const Attachment& original, MirrorAxis axis);

// The root, of the given size (m), centred at the origin, its long axis at the angle (rad).
PlannedPart place_root(double length, double width, double angle);

// A child of the given size at rest; handedness is its parent's. Sets size, poses and anchors.
PlannedPart place_child(const PlannedPart& parent, int parent_handedness,
                        const Attachment& attachment, double length, double width);

// Whether a part lies within another, almost parallel to it: its centre within the middle 70 % both
// ways and the long axes within 17 degrees.
bool is_buried(const PlannedPart& part, const PlannedPart& other);

}  // namespace cambrian
