#pragma once

// The joints of planar scenes. The equations know a joint by its motion only; a kind adds how genes
// become limits and strength.

#include "world/joint_kind.h"

namespace cambrian {

// A new joint is one file in joints/ and one line in the registry's list.
JointKind rigid_joint();
JointKind revolute_joint();
JointKind prismatic_joint();

// Digests of genes count joints in this order: new kinds go to the end.
JointRegistry builtin_joints();

}  // namespace cambrian
