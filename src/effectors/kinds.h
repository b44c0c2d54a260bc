#pragma once

// Registers the effector kinds, one file each.

#include "effectors/effector.h"

namespace cambrian {

void add_joint_effector(EffectorRegistry& effectors);

}  // namespace cambrian
