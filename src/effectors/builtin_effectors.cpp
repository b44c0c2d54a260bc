#include "effectors/kinds.h"

namespace cambrian {

EffectorRegistry builtin_effectors() {
    EffectorRegistry effectors;
    add_joint_effector(effectors);
    return effectors;
}

}  // namespace cambrian
