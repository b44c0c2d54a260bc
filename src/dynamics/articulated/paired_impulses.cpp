#include "dynamics/articulated/paired_impulses.h"

#include "dynamics/articulated/stretched_tree.h"

namespace cambrian {
namespace {

void solve_stretched_pair(const PlanarModel& model, const Kinematics& k, const Factors& factors,
                          const Loads (&impulses)[2], PerCoordinate (&jumps)[2]) {
    for (int which = 0; which < 2; ++which) {
        BodyResponse response;
        solve_stretched_impulse(model, k, factors, impulses[which], response);
        for (int c = 0; c < coordinate_count(model); ++c)
            jumps[which][c] = response.coordinate[c];
    }
}

// A scalar of both impulses is a Simd2d; a planar vector of both is Simd4d (x, y, x, y).
CAMBRIAN_INLINE Simd4d twice(double x, double y) {
    return Simd4d{x, y, x, y};
}
CAMBRIAN_INLINE Simd4d for_each_axis(const Simd2d& values) {
    return __builtin_shufflevector(values, values, 0, 0, 1, 1);
}
CAMBRIAN_INLINE Simd2d dots(const Simd4d& a, const Simd4d& b) {
    const Simd4d product = a * b;
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
            force_[i] = Simd4d{impulses[0].force_x[i], impulses[0].force_y[i],
                               impulses[1].force_x[i], impulses[1].force_y[i]};
            effort_[i] = Simd2d{impulses[0].effort[i], impulses[1].effort[i]};
            torque_[i] = Simd2d{impulses[0].torque[i], impulses[1].torque[i]} +
                         dots(twice(k_.s_x[i], k_.s_y[i]), force_[i]);
        }
    }

    CAMBRIAN_INLINE void pass_to_parent(int i) {
        const int p = model_.parent[i];
        const bool is_prismatic = model_.motion[i] == JointMotion::kSlide;
        const Simd2d& effort = effort_[i];
        const Simd2d& torque = torque_[i];
        u_[i] =
            effort + (is_prismatic ? dots(twice(k_.axis_x[i], k_.axis_y[i]), force_[i]) : torque);
        const Simd2d share = u_[i] * factors_.inverse_d[i];
        const Simd4d passed =
            force_[i] - twice(factors_.w_x[i], factors_.w_y[i]) * for_each_axis(share);
        force_[p] += passed;
        torque_[p] += dots(twice(k_.z_x[i], k_.z_y[i]), passed) +
                      (is_prismatic ? torque - factors_.w_3[i] * share
                                    : factors_.damping[i] * share - effort);
    }

    CAMBRIAN_INLINE void move_root(int tree, PerCoordinate (&jumps)[2]) {
        const int root = model_.tree_begin[tree];
        const RootInverse& inverse = factors_.root[tree];
        const Simd4d& force = force_[root];
        const Simd2d f_x = __builtin_shufflevector(force, force, 0, 2);
        const Simd2d f_y = __builtin_shufflevector(force, force, 1, 3);
        const Simd2d& t = torque_[root];
        const Simd2d x = inverse.xx * f_x + inverse.xy * f_y + inverse.xt * t;
        const Simd2d y = inverse.xy * f_x + inverse.yy * f_y + inverse.yt * t;
        jump_[root] = __builtin_shufflevector(x, y, 0, 2, 1, 3);
        spin_[root] = inverse.xt * f_x + inverse.yt * f_y + inverse.tt * t;
        store(root, spin_[root], jumps);
    }

    CAMBRIAN_INLINE void follow_parent(int i, PerCoordinate (&jumps)[2]) {
        const int p = model_.parent[i];
        const Simd2d& spin = spin_[p];
        const Simd4d jump = jump_[p] + twice(k_.z_x[i], k_.z_y[i]) * for_each_axis(spin);
        const Simd2d rest = u_[i] - dots(twice(factors_.w_x[i], factors_.w_y[i]), jump);
        if (model_.motion[i] == JointMotion::kSlide) {
            const Simd2d slide = (rest - factors_.w_3[i] * spin) * factors_.inverse_d[i];
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
    CAMBRIAN_INLINE static void store(int i, const Simd2d& values, PerCoordinate (&jumps)[2]) {
        jumps[0][i] = values[0];
        jumps[1][i] = values[1];
    }

    const PlanarModel& model_;
    const Kinematics& k_;
    const Factors& factors_;
    Simd4d force_[kMaxBodies];
    Simd2d torque_[kMaxBodies];  // about the pivots
    Simd2d effort_[kMaxBodies];
    Simd2d u_[kMaxBodies];
    Simd4d jump_[kMaxBodies];  // of the pivots
    Simd2d spin_[kMaxBodies];
};

}  // namespace

void solve_paired_impulses(const PlanarModel& model, const Kinematics& kinematics,
                           const Factors& factors, const Loads (&impulses)[2],
                           PerCoordinate (&jumps)[2]) {
    if (model.stretch_count > 0)
        return solve_stretched_pair(model, kinematics, factors, impulses, jumps);
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
        const double* members = model.members_of(tree).membership;
        const int center = center_of(model, tree);
        for (int which = 0; which < 2; ++which) {
            const Loads& loads = impulses[which];
            jumps[which][center] = share * lane_product(members, loads.force_x, slots);
            jumps[which][center + 1] = share * lane_product(members, loads.force_y, slots);
        }
    }
}

}  // namespace cambrian
