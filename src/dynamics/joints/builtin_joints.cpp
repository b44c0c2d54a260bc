#include "dynamics/joints/builtin_joints.h"

namespace cambrian {

JointRegistry builtin_joints() {
    JointRegistry joints;
    joints.add(rigid_joint());
    joints.add(revolute_joint());
    joints.add(prismatic_joint());
    return joints;
}

}  // namespace cambrian
