#include "dynamics/articulated/paired_impulses.h"

namespace cambrian {
namespace {

// A scalar of both impulses is a Pair; a planar vector of both is Lanes (x, y, x, y).
CAMBRIAN_INLINE Lanes twice(double x, double y) {
    return Lanes{x, y, x, y};
}
CAMBRIAN_INLINE Lanes for_each_axis(const Pair& values) {
    return __builtin_shufflevector(values, values, 0, 0, 1, 1);
}
CAMBRIAN_INLINE Pair dots(const Lanes& a, const Lanes& b) {
    const Lanes product = a * b;
    return __builtin_shufflevector(product, product, 0, 2) +
           __builtin_shufflevector(product, product, 1, 3);
}

class PairedImpulses {
public:
    CAMBRIAN_INLINE PairedImpulses(const PlanarModel& model, const Kinematics& kinematics,
                                   const Factors& factors)
        : model_(model), k_(kinematics), factors_(factors) {}

    CAMBRIAN_INLINE void load(const Loads (&impulses)[2]) {
        for (int i = 0; i < model_.body_count; ++i) {
            force_[i] = Lanes{impulses[0].force_x[i], impulses[0].force_y[i],
                              impulses[1].force_x[i], impulses[1].force_y[i]};
            effort_[i] = Pair{impulses[0].effort[i], impulses[1].effort[i]};
            torque_[i] = Pair{impulses[0].torque[i], impulses[1].torque[i]} +
                         dots(twice(k_.s_x[i], k_.s_y[i]), force_[i]);
        }
    }

    CAMBRIAN_INLINE void pass_to_parent(int i) {
        const int p = model_.parent[i];
        const bool is_prismatic = model_.motion[i] == JointMotion::kSlide;
        const Pair& effort = effort_[i];
        const Pair& torque = torque_[i];
        u_[i] =
            effort + (is_prismatic ? dots(twice(k_.axis_x[i], k_.axis_y[i]), force_[i]) : torque);
        const Pair share = u_[i] * factors_.inverse_d[i];
        const Lanes passed =
            force_[i] - twice(factors_.w_x[i], factors_.w_y[i]) * for_each_axis(share);
        force_[p] += passed;
        torque_[p] += dots(twice(k_.z_x[i], k_.z_y[i]), passed) +
                      (is_prismatic ? torque - factors_.w_3[i] * share
                                    : factors_.damping[i] * share - effort);
    }

    CAMBRIAN_INLINE void move_root(int tree, PerCoordinate (&jumps)[2]) {
        const int root = model_.tree_begin[tree];
        const RootInverse& inverse = factors_.root[tree];
        const Lanes& force = force_[root];
        const Pair f_x = __builtin_shufflevector(force, force, 0, 2);
        const Pair f_y = __builtin_shufflevector(force, force, 1, 3);
        const Pair& t = torque_[root];
        const Pair x = inverse.xx * f_x + inverse.xy * f_y + inverse.xt * t;
        const Pair y = inverse.xy * f_x + inverse.yy * f_y + inverse.yt * t;
        jump_[root] = __builtin_shufflevector(x, y, 0, 2, 1, 3);
        spin_[root] = inverse.xt * f_x + inverse.yt * f_y + inverse.tt * t;
        store(root, spin_[root], jumps);
    }

    CAMBRIAN_INLINE void follow_parent(int i, PerCoordinate (&jumps)[2]) {
        const int p = model_.parent[i];
        const Pair& spin = spin_[p];
        const Lanes jump = jump_[p] + twice(k_.z_x[i], k_.z_y[i]) * for_each_axis(spin);
        const Pair rest = u_[i] - dots(twice(factors_.w_x[i], factors_.w_y[i]), jump);
        if (model_.motion[i] == JointMotion::kSlide) {
            const Pair slide = (rest - factors_.w_3[i] * spin) * factors_.inverse_d[i];
            jump_[i] = jump + twice(k_.axis_x[i], k_.axis_y[i]) * for_each_axis(slide);
            spin_[i] = spin;
            store(i, slide, jumps);
            return;
        }
        jump_[i] = jump;
        spin_[i] = (rest + factors_.damping[i] * spin) * factors_.inverse_d[i];
        store(i, spin_[i], jumps);
    }

private:
    CAMBRIAN_INLINE static void store(int i, const Pair& values, PerCoordinate (&jumps)[2]) {
        jumps[0][i] = values[0];
        jumps[1][i] = values[1];
    }

    const PlanarModel& model_;
    const Kinematics& k_;
    const Factors& factors_;
    Lanes force_[kMaxBodies];
    Pair torque_[kMaxBodies];  // about the pivots
    Pair effort_[kMaxBodies];
    Pair u_[kMaxBodies];
    Lanes jump_[kMaxBodies];  // of the pivots
    Pair spin_[kMaxBodies];
};

}  // namespace

void solve_paired_impulses(const PlanarModel& model, const Kinematics& kinematics,
                           const Factors& factors, const Loads (&impulses)[2],
                           PerCoordinate (&jumps)[2]) {
    PairedImpulses paired(model, kinematics, factors);
    paired.load(impulses);
    const int slots = round_up_to_lanes(model.body_count);
    for (int tree = model.tree_count - 1; tree >= 0; --tree) {
        const int root = model.tree_begin[tree];
        const int end = model.tree_begin[tree + 1];
        for (int i = end - 1; i > root; --i)
            paired.pass_to_parent(i);
        paired.move_root(tree, jumps);
        for (int i = root + 1; i < end; ++i)
            paired.follow_parent(i, jumps);
        const double share = 1.0 / model.tree_mass[tree];
        const double* members = model.membership[tree];
        const int center = center_of(model, tree);
        for (int which = 0; which < 2; ++which) {
            const Loads& loads = impulses[which];
            jumps[which][center] = share * lane_product(members, loads.force_x, slots);
            jumps[which][center + 1] = share * lane_product(members, loads.force_y, slots);
        }
    }
}

}  // namespace cambrian
