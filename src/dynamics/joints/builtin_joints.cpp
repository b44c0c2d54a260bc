#include "dynamics/joints/builtin_joints.h"

namespace cambrian {

JointRegistry builtin_joints() {
    JointRegistry joints;
    joints.add(rigid_joint());
    joints.add(rotary_joint());
    joints.add(linear_joint());
    return joints;
}

}  // namespace cambrian
