#include "dynamics/kinematics.h"

#include "math/elementary.h"

namespace cambrian {
namespace {

void compute_angles(const PlanarModel& model, const Motion& motion, Kinematics& k) {
    const int n = model.body_count;
    k.angle[0] = motion.position[2];
    k.spin[0] = motion.speed[2];
    for (int i = 1; i < n; ++i) {
        const int p = model.parent[i];
        const bool linear = model.joint[i] == JointType::kLinear;
        k.angle[i] = linear ? k.angle[p] + model.rest_angle[i] : motion.position[coordinate_of(i)];
        k.spin[i] = linear ? k.spin[p] : motion.speed[coordinate_of(i)];
    }
    for (int i = 0; i < n; ++i) {
        const SineCosine turn = sine_cosine_reduced(k.angle[i]);
        k.sine[i] = turn.sine;
        k.cosine[i] = turn.cosine;
    }
}

// c_i = c_p + r_p - r_c,  v_i = v_p + w_p z + w_i s,  gamma = -w_p^2 r_p + w_i^2 r_c.
inline void place_rotary(const PlanarModel& model, Kinematics& k, int i, int p) {
    const double parent_x =
        k.cosine[p] * model.parent_anchor_x[i] - k.sine[p] * model.parent_anchor_y[i];
    const double parent_y =
        k.sine[p] * model.parent_anchor_x[i] + k.cosine[p] * model.parent_anchor_y[i];
    const double child_x =
        k.cosine[i] * model.child_anchor_x[i] - k.sine[i] * model.child_anchor_y[i];
    const double child_y =
        k.sine[i] * model.child_anchor_x[i] + k.cosine[i] * model.child_anchor_y[i];
    const double parent_spin = k.spin[p];
    const double spin = k.spin[i];
    k.z_x[i] = -parent_y;
    k.z_y[i] = parent_x;
    k.s_x[i] = child_y;
    k.s_y[i] = -child_x;
    k.gamma_x[i] = spin * spin * child_x - parent_spin * parent_spin * parent_x;
    k.gamma_y[i] = spin * spin * child_y - parent_spin * parent_spin * parent_y;
    k.x[i] = k.x[p] + parent_x - child_x;
    k.y[i] = k.y[p] + parent_y - child_y;
    k.velocity_x[i] = k.velocity_x[p] - parent_spin * parent_y + spin * child_y;
    k.velocity_y[i] = k.velocity_y[p] + parent_spin * parent_x - spin * child_x;
}

// rho = R_p (a + s e) - R_i b,  c_i = c_p + rho,  v_i = v_p + w_p z + s' n,
// gamma = -w_p^2 rho + 2 w_p s' perp(n).
inline void place_linear(const PlanarModel& model, const Motion& motion, Kinematics& k, int i,
                         int p) {
    const double slide = motion.position[coordinate_of(i)];
    const double rate = motion.speed[coordinate_of(i)];
    const double axis_x = k.cosine[p] * model.axis_x[i] - k.sine[p] * model.axis_y[i];
    const double axis_y = k.sine[p] * model.axis_x[i] + k.cosine[p] * model.axis_y[i];
    const double anchor_x = model.parent_anchor_x[i];
    const double anchor_y = model.parent_anchor_y[i];
    const double rho_x =
        k.cosine[p] * anchor_x - k.sine[p] * anchor_y + slide * axis_x -
        (k.cosine[i] * model.child_anchor_x[i] - k.sine[i] * model.child_anchor_y[i]);
    const double rho_y =
        k.sine[p] * anchor_x + k.cosine[p] * anchor_y + slide * axis_y -
        (k.sine[i] * model.child_anchor_x[i] + k.cosine[i] * model.child_anchor_y[i]);
    const double spin = k.spin[p];
    k.z_x[i] = -rho_y;
    k.z_y[i] = rho_x;
    k.s_x[i] = axis_x;
    k.s_y[i] = axis_y;
    k.gamma_x[i] = -spin * spin * rho_x - 2.0 * spin * rate * axis_y;
    k.gamma_y[i] = -spin * spin * rho_y + 2.0 * spin * rate * axis_x;
    k.x[i] = k.x[p] + rho_x;
    k.y[i] = k.y[p] + rho_y;
    k.velocity_x[i] = k.velocity_x[p] - spin * rho_y + rate * axis_x;
    k.velocity_y[i] = k.velocity_y[p] + spin * rho_x + rate * axis_y;
}

// The tree was placed from an arbitrary root point; moves it so that the mean is the state's.
void shift_to_center(const PlanarModel& model, const Motion& motion, Kinematics& k) {
    double x = 0.0;
    double y = 0.0;
    double velocity_x = 0.0;
    double velocity_y = 0.0;
    for (int i = 0; i < model.body_count; ++i) {
        x += model.mass[i] * k.x[i];
        y += model.mass[i] * k.y[i];
        velocity_x += model.mass[i] * k.velocity_x[i];
        velocity_y += model.mass[i] * k.velocity_y[i];
    }
    const double share = 1.0 / model.total_mass;
    x = motion.position[0] - share * x;
    y = motion.position[1] - share * y;
    velocity_x = motion.speed[0] - share * velocity_x;
    velocity_y = motion.speed[1] - share * velocity_y;
    for (int i = 0; i < model.body_count; ++i) {
        k.x[i] += x;
        k.y[i] += y;
        k.velocity_x[i] += velocity_x;
        k.velocity_y[i] += velocity_y;
    }
}

}  // namespace

void compute_kinematics(const PlanarModel& model, const Motion& motion, Kinematics& kinematics) {
    compute_angles(model, motion, kinematics);
    kinematics.x[0] = 0.0;
    kinematics.y[0] = 0.0;
    kinematics.velocity_x[0] = 0.0;
    kinematics.velocity_y[0] = 0.0;
    for (int i = 1; i < model.body_count; ++i) {
        const int p = model.parent[i];
        if (model.joint[i] == JointType::kLinear)
            place_linear(model, motion, kinematics, i, p);
        else
            place_rotary(model, kinematics, i, p);
    }
    shift_to_center(model, motion, kinematics);
}

double kinetic_energy(const PlanarModel& model, const Kinematics& k) {
    double energy = 0.0;
    for (int i = 0; i < model.body_count; ++i) {
        energy += model.mass[i] *
                      (k.velocity_x[i] * k.velocity_x[i] + k.velocity_y[i] * k.velocity_y[i]) +
                  model.inertia[i] * k.spin[i] * k.spin[i];
    }
    return 0.5 * energy;
}

}  // namespace cambrian
