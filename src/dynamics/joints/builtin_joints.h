#pragma once

// The joints of planar scenes. The equations depend only on a joint's motion; a kind adds how genes
// determine limits and strength.

#include "world/joint_kind.h"

namespace cambrian {

// A new joint is one file in joints/ and one line in the registry's list.
JointKind rigid_joint();
JointKind revolute_joint();
JointKind prismatic_joint();

// Digests of genes include joint numbers in this order, so new kinds must be added at the end.
JointRegistry builtin_joints();

}  // namespace cambrian
