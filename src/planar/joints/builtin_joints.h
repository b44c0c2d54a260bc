#pragma once

// The joints of planar scenes. The equations depend only on a joint's motion; a kind adds how genes
// determine limits and strength.

#include "world/joint_kind.h"

namespace cambrian {

// A new joint is one file in joints/ and one line in the registry's list.
void add_rigid_joint(JointRegistry& joints);
void add_revolute_joint(JointRegistry& joints);
void add_prismatic_joint(JointRegistry& joints);

// Digests of genes include joint numbers in this order, so new kinds must be added at the end.
JointRegistry builtin_joints();

}  // namespace cambrian
