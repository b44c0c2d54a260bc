// A rigid joint: its part and the parent are one body.

#include "dynamics/joints/builtin_joints.h"

namespace cambrian {

JointKind rigid_joint() {
    return {.id = "rigid", .label = "Rigid", .motion = JointMotion::kFixed};
}

}  // namespace cambrian
