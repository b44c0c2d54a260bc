#include "dynamics/model/pins.h"

namespace cambrian {

Vec2 turned(const Kinematics& k, Eigen::Index body, double x, double y) {
    return {k.cosine[body] * x - k.sine[body] * y, k.sine[body] * x + k.cosine[body] * y};
}

Vec2 place(const Kinematics& k, Eigen::Index body) {
    return {k.x[body], k.y[body]};
}

PinArms pin_arms(const Kinematics& k, const BodyPin& pin) {
    return {turned(k, pin.body_a, pin.a_x, pin.a_y), turned(k, pin.body_b, pin.b_x, pin.b_y)};
}

Vec2 pin_gap(const Kinematics& k, const BodyPin& pin, const PinArms& arms) {
    return place(k, pin.body_a) + arms.a - place(k, pin.body_b) - arms.b;
}

Vec2 pin_bias(const Kinematics& k, const BodyPin& pin, const PinArms& arms) {
    const double spin_a = k.spin[pin.body_a];
    const double spin_b = k.spin[pin.body_b];
    return spin_b * spin_b * arms.b - spin_a * spin_a * arms.a;
}

}  // namespace cambrian
