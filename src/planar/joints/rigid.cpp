// A rigid joint: its part and the parent are one body.

#include "planar/joints/builtin_joints.h"

namespace cambrian {

void add_rigid_joint(JointRegistry& joints) {
    joints.add({.id = "rigid", .label = "Rigid", .motion = JointMotion::kFixed});
}

}  // namespace cambrian
