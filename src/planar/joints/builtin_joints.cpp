#include "planar/joints/builtin_joints.h"

namespace cambrian {

JointRegistry builtin_joints() {
    JointRegistry joints;
    add_rigid_joint(joints);
    add_revolute_joint(joints);
    add_prismatic_joint(joints);
    return joints;
}

}  // namespace cambrian
