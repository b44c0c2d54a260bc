// Holds its part to the parent; both are one body.

#include "dynamics/joints/builtin_joints.h"

namespace cambrian {

JointKind rigid_joint() {
    return {.id = "rigid", .label = "Rigid", .motion = JointMotion::kFixed};
}

}  // namespace cambrian
