#pragma once

#include "world/joint_kind.h"

namespace cambrian {

// Returns the joints of bodies in space. The first are those of the plane, in its order, so that
// genes of the plane keep their meaning.
JointRegistry spatial_joints();

}  // namespace cambrian
