#include "dynamics/model/loop_joints.h"

namespace cambrian {

Vec2 turned(const Kinematics& k, Eigen::Index body, double x, double y) {
    return {k.cosine[body] * x - k.sine[body] * y, k.sine[body] * x + k.cosine[body] * y};
}

Vec2 place(const Kinematics& k, Eigen::Index body) {
    return {k.x[body], k.y[body]};
}

LoopArms loop_arms(const Kinematics& k, const LoopJoint& joint) {
    return {turned(k, joint.body_a, joint.a_x, joint.a_y),
            turned(k, joint.body_b, joint.b_x, joint.b_y)};
}

Vec2 loop_gap(const Kinematics& k, const LoopJoint& joint, const LoopArms& arms) {
    return place(k, joint.body_a) + arms.a - place(k, joint.body_b) - arms.b;
}

Vec2 loop_bias(const Kinematics& k, const LoopJoint& joint, const LoopArms& arms) {
    const double spin_a = k.spin[joint.body_a];
    const double spin_b = k.spin[joint.body_b];
    return spin_b * spin_b * arms.b - spin_a * spin_a * arms.a;
}

}  // namespace cambrian
