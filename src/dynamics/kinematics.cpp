#include "dynamics/kinematics.h"

#include "math/elementary.h"

namespace cambrian {
namespace {

// Bodies behind linear joints turn with their parents; their coordinates are lengths.
CAMBRIAN_INLINE void turn_with_parents(const PlanarModel& model, Kinematics& k) {
    for (int i = 0; i < model.body_count; ++i) {
        if (model.joint[i] != JointType::kLinear) continue;
        const int p = model.parent[i];
        k.angle[i] = k.angle[p] + model.rest_angle[i];
        k.spin[i] = k.spin[p];
    }
}

CAMBRIAN_INLINE void compute_angles(const PlanarModel& model, const Motion& motion, Kinematics& k) {
    const int slots = round_up_to_lanes(model.body_count);
    for (int i = 0; i < slots; i += kLanes) {
        store_lanes(k.angle + i, load_lanes(motion.position + i));
        store_lanes(k.spin + i, load_lanes(motion.speed + i));
    }
    for (int i = model.body_count; i < slots; ++i) {
        k.angle[i] = 0.0;
        k.spin[i] = 0.0;
    }
    if (model.has_linear) turn_with_parents(model, k);
    for (int i = 0; i < slots; i += kLanes) {
        for (int lane = i; lane < i + kLanes; ++lane) {
            const SineCosine turn = sine_cosine_reduced(k.angle[lane]);
            k.sine[lane] = turn.sine;
            k.cosine[lane] = turn.cosine;
        }
    }
}

// z = perp(r_p), s = -perp(r_c), gamma = -w_p^2 r_p + w_i^2 r_c, with the arms r_p and r_c from the
// parent's and the child's centre to the joint.
CAMBRIAN_INLINE void turn_joints(const PlanarModel& model, Kinematics& k, int first) {
    const int* parents = model.parent_slot + first;
    const Lanes parent_cosine = gather(k.cosine, parents);
    const Lanes parent_sine = gather(k.sine, parents);
    const Lanes parent_spin = gather(k.spin, parents);
    const Lanes parent_angle = gather(k.angle, parents);
    const Lanes cosine = load_lanes(k.cosine + first);
    const Lanes sine = load_lanes(k.sine + first);
    const Lanes spin = load_lanes(k.spin + first);
    const Lanes parent_anchor_x = load_lanes(model.parent_anchor_x + first);
    const Lanes parent_anchor_y = load_lanes(model.parent_anchor_y + first);
    const Lanes child_anchor_x = load_lanes(model.child_anchor_x + first);
    const Lanes child_anchor_y = load_lanes(model.child_anchor_y + first);
    const Lanes parent_x = parent_cosine * parent_anchor_x - parent_sine * parent_anchor_y;
    const Lanes parent_y = parent_sine * parent_anchor_x + parent_cosine * parent_anchor_y;
    const Lanes child_x = cosine * child_anchor_x - sine * child_anchor_y;
    const Lanes child_y = sine * child_anchor_x + cosine * child_anchor_y;
    const Lanes parent_square = parent_spin * parent_spin;
    const Lanes square = spin * spin;
    store_lanes(k.z_x + first, -parent_y);
    store_lanes(k.z_y + first, parent_x);
    store_lanes(k.s_x + first, child_y);
    store_lanes(k.s_y + first, -child_x);
    store_lanes(k.gamma_x + first, square * child_x - parent_square * parent_x);
    store_lanes(k.gamma_y + first, square * child_y - parent_square * parent_y);
    store_lanes(k.joint_position + first,
                load_lanes(k.angle + first) - parent_angle - load_lanes(model.rest_angle + first));
    store_lanes(k.joint_rate + first, spin - parent_spin);
}

// rho = R_p (a + s e) - R_i b, z = perp(rho), s = n, gamma = -w_p^2 rho + 2 w_p s' perp(n).
CAMBRIAN_INLINE void slide_joint(const PlanarModel& model, const Motion& motion, Kinematics& k,
                                 int i) {
    const int p = model.parent[i];
    const double slide = motion.position[i];
    const double rate = motion.speed[i];
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
    k.joint_position[i] = slide;
    k.joint_rate[i] = rate;
}

// Every body holds its offset from its parent, roots hold anything: sums the offsets down the trees
// and moves each so that its mean is the given centre.
CAMBRIAN_INLINE void sum_from_roots(const PlanarModel& model, const double* center, double* x,
                                    double* y) {
    const int slots = round_up_to_lanes(model.body_count);
    for (int t = 0; t < model.tree_count; ++t) {
        const int root = model.tree_begin[t];
        x[root] = 0.0;
        y[root] = 0.0;
        for (int i = root + 1; i < model.tree_begin[t + 1]; ++i) {
            const int p = model.parent[i];
            x[i] += x[p];
            y[i] += y[p];
        }
    }
    for (int t = 0; t < model.tree_count; ++t) {
        const double* share = model.tree_share[t];
        const Lanes shift_x =
            all_lanes(center[center_of(model, t)] - lane_product(share, x, slots));
        const Lanes shift_y =
            all_lanes(center[center_of(model, t) + 1] - lane_product(share, y, slots));
        for (int i = 0; i < slots; i += kLanes) {
            const Lanes member = load_lanes(model.membership[t] + i);
            store_lanes(x + i, load_lanes(x + i) + member * shift_x);
            store_lanes(y + i, load_lanes(y + i) + member * shift_y);
        }
    }
}

}  // namespace

CAMBRIAN_WIDE void compute_joints(const PlanarModel& model, const Motion& motion, Kinematics& k) {
    compute_angles(model, motion, k);
    for (int first = 0; first < model.body_count; first += kLanes)
        turn_joints(model, k, first);
    if (!model.has_linear) return;
    for (int i = 0; i < model.body_count; ++i) {
        if (model.joint[i] == JointType::kLinear) slide_joint(model, motion, k, i);
    }
}

// v_i = v_p + w_p z + s_i' s.
CAMBRIAN_WIDE void compute_velocities(const PlanarModel& model, const Motion& motion,
                                      Kinematics& k) {
    for (int i = 0; i < model.body_count; i += kLanes) {
        const Lanes spin = gather(k.spin, model.parent_slot + i);
        const Lanes rate = load_lanes(motion.speed + i);
        store_lanes(k.velocity_x + i, spin * load_lanes(k.z_x + i) + rate * load_lanes(k.s_x + i));
        store_lanes(k.velocity_y + i, spin * load_lanes(k.z_y + i) + rate * load_lanes(k.s_y + i));
    }
    sum_from_roots(model, motion.speed, k.velocity_x, k.velocity_y);
}

// c_i = c_p - perp(z), and - perp(s) at rotary joints.
CAMBRIAN_WIDE void compute_places(const PlanarModel& model, const Motion& motion, Kinematics& k) {
    for (int i = 0; i < model.body_count; i += kLanes) {
        const Lanes turning = all_lanes(1.0) - load_lanes(model.slides + i);
        store_lanes(k.x + i, load_lanes(k.z_y + i) + turning * load_lanes(k.s_y + i));
        store_lanes(k.y + i, -load_lanes(k.z_x + i) - turning * load_lanes(k.s_x + i));
    }
    sum_from_roots(model, motion.position, k.x, k.y);
}

void compute_kinematics(const PlanarModel& model, const Motion& motion, Kinematics& kinematics) {
    compute_joints(model, motion, kinematics);
    compute_velocities(model, motion, kinematics);
    compute_places(model, motion, kinematics);
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
