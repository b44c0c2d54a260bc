#pragma once

// The joints of planar scenes. The equations know a joint by its motion only; a kind adds how genes
// become limits and strength.

#include "world/joint_kind.h"

namespace cambrian {

// A new joint is one file in joints/ and one line in the registry's list.
void add_rigid_joint(JointRegistry& joints);
void add_revolute_joint(JointRegistry& joints);
void add_prismatic_joint(JointRegistry& joints);

// Digests of genes count joints in this order: new kinds go to the end.
JointRegistry builtin_joints();

}  // namespace cambrian
