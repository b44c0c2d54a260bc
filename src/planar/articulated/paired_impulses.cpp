
#include "planar/articulated/articulated_body.h"

namespace cambrian {
namespace {

void solve_stretched_pair(const PlanarModel& model, const Kinematics& k, const Factors& factors,
                          const Loads (&impulses)[2], PerCoordinate (&jumps)[2]) {
    for (int which = 0; which < 2; ++which) {
        BodyResponse response;
        solve_stretched_impulse(model, k, factors, impulses[which], response);
        const int count = coordinate_count(model);
        for (int c = 0; c < coordinate_slots(model); ++c)
            jumps[which][c] = c < count ? response.coordinate[c] : 0.0;
    }
}

// A scalar of both impulses is a Simd2d; a planar vector of both is Simd4d (x, x, y, y).
CAMBRIAN_INLINE Simd4d twice(double x, double y) {
    return Simd4d{x, x, y, y};
}
CAMBRIAN_INLINE Simd4d for_each_axis(const Simd2d& values) {
    return __builtin_shufflevector(values, values, 0, 1, 0, 1);
}
CAMBRIAN_INLINE Simd2d x_of(const Simd4d& vectors) {
    return __builtin_shufflevector(vectors, vectors, 0, 1);
}
CAMBRIAN_INLINE Simd2d y_of(const Simd4d& vectors) {
    return __builtin_shufflevector(vectors, vectors, 2, 3);
}
CAMBRIAN_INLINE Simd2d dots(const Simd4d& a, const Simd4d& b) {
    const Simd4d product = a * b;
    return x_of(product) + y_of(product);
}

// kHasPrismatic: whether some joints may be prismatic.
template <bool kHasPrismatic>
class PairedImpulses {
public:
    CAMBRIAN_INLINE PairedImpulses(const PlanarModel& model, const Kinematics& kinematics,
                                   const Factors& factors)
        : model_(model), k_(kinematics), factors_(factors) {}

    CAMBRIAN_INLINE void load(const Loads (&impulses)[2]) {
        for (int i = 0; i < model_.body_count; ++i) {
            Body& body = bodies_[i];
            body.force = Simd4d{impulses[0].force_x[i], impulses[1].force_x[i],
                                impulses[0].force_y[i], impulses[1].force_y[i]};
            body.effort = Simd2d{impulses[0].effort[i], impulses[1].effort[i]};
            body.torque = Simd2d{impulses[0].torque[i], impulses[1].torque[i]} +
                          dots(twice(k_.s_x[i], k_.s_y[i]), body.force);
        }
    }

    CAMBRIAN_INLINE void load(const PerBody (&efforts)[2]) {
        for (int i = 0; i < model_.body_count; ++i) {
            Body& body = bodies_[i];
            body.force = Simd4d{};
            body.effort = Simd2d{efforts[0][i], efforts[1][i]};
            body.torque = Simd2d{};
        }
    }

    CAMBRIAN_INLINE void solve(PerCoordinate (&jumps)[2]) {
        for (int tree = model_.tree_count - 1; tree >= 0; --tree) {
            const int root = model_.tree_begin[tree];
            const int end = model_.tree_begin[tree + 1];
            for (int i = end - 1; i > root; --i)
                pass_to_parent(i);
            move_root(tree, jumps);
            for (int i = root + 1; i < end; ++i)
                follow_parent(i, jumps);
        }
    }

private:
    struct Body {
        Simd4d force;   // of its subtree
        Simd4d jump;    // of the pivot
        Simd2d torque;  // of its subtree, about the pivot
        Simd2d effort;
        Simd2d u;
        Simd2d spin;
    };

    CAMBRIAN_INLINE bool is_prismatic(int i) const {
        return kHasPrismatic && model_.motion[i] == JointMotion::kSlide;
    }

    CAMBRIAN_INLINE void pass_to_parent(int i) {
        Body& body = bodies_[i];
        Body& parent = bodies_[model_.parent[i]];
        const Simd2d along =
            is_prismatic(i) ? dots(twice(k_.axis_x[i], k_.axis_y[i]), body.force) : body.torque;
        const Simd2d u = body.effort + along;
        const Simd2d share = u * factors_.inverse_d[i];
        const Simd4d passed =
            body.force - twice(factors_.w_x[i], factors_.w_y[i]) * for_each_axis(share);
        body.u = u;
        parent.force += passed;
        parent.torque += dots(twice(k_.z_x[i], k_.z_y[i]), passed) +
                         (is_prismatic(i) ? body.torque - factors_.w_3[i] * share
                                          : factors_.damping[i] * share - body.effort);
    }

    CAMBRIAN_INLINE void move_root(int tree, PerCoordinate (&jumps)[2]) {
        const int root = model_.tree_begin[tree];
        const RootInverse& inverse = factors_.root[tree];
        Body& body = bodies_[root];
        const Simd2d f_x = x_of(body.force);
        const Simd2d f_y = y_of(body.force);
        const Simd2d& t = body.torque;
        const Simd2d x = inverse.xx * f_x + inverse.xy * f_y + inverse.xt * t;
        const Simd2d y = inverse.xy * f_x + inverse.yy * f_y + inverse.yt * t;
        body.jump = __builtin_shufflevector(x, y, 0, 1, 2, 3);
        body.spin = inverse.xt * f_x + inverse.yt * f_y + inverse.tt * t;
        store(root, body.spin, jumps);
    }

    CAMBRIAN_INLINE void follow_parent(int i, PerCoordinate (&jumps)[2]) {
        Body& body = bodies_[i];
        const Body& parent = bodies_[model_.parent[i]];
        const Simd2d spin = parent.spin;
        const Simd4d jump = parent.jump + twice(k_.z_x[i], k_.z_y[i]) * for_each_axis(spin);
        const Simd2d rest = body.u - dots(twice(factors_.w_x[i], factors_.w_y[i]), jump);
        if (is_prismatic(i)) {
            const Simd2d slide = (rest - factors_.w_3[i] * spin) * factors_.inverse_d[i];
            body.jump = jump + twice(k_.axis_x[i], k_.axis_y[i]) * for_each_axis(slide);
            body.spin = spin;
            store(i, slide, jumps);
            return;
        }
        const Simd2d turn = (rest + factors_.damping[i] * spin) * factors_.inverse_d[i];
        body.jump = jump;
        body.spin = turn;
        store(i, turn, jumps);
    }

    CAMBRIAN_INLINE static void store(int i, const Simd2d& values, PerCoordinate (&jumps)[2]) {
        jumps[0][i] = values[0];
        jumps[1][i] = values[1];
    }

    const PlanarModel& model_;
    const Kinematics& k_;
    const Factors& factors_;
    Body bodies_[kMaxBodies];
};

// Sets the jumps of the centres of mass, and what is beyond the coordinates, to 0.
CAMBRIAN_INLINE void clear_centers(const PlanarModel& model, PerCoordinate (&jumps)[2]) {
    for (auto& jump : jumps) {
        for (int c = model.body_count; c < coordinate_slots(model); ++c)
            jump[c] = 0.0;
    }
}

template <class Impulses>
CAMBRIAN_INLINE void solve_pair(const PlanarModel& model, const Kinematics& k,
                                const Factors& factors, const Impulses& impulses,
                                PerCoordinate (&jumps)[2]) {
    clear_centers(model, jumps);
    if (model.has_slides) {
        PairedImpulses<true> paired(model, k, factors);
        paired.load(impulses);
        paired.solve(jumps);
    } else {
        PairedImpulses<false> paired(model, k, factors);
        paired.load(impulses);
        paired.solve(jumps);
    }
}

}  // namespace

void solve_paired_impulses(const PlanarModel& model, const Kinematics& kinematics,
                           const Factors& factors, const Loads (&impulses)[2],
                           PerCoordinate (&jumps)[2]) {
    if (model.stretch_count > 0)
        return solve_stretched_pair(model, kinematics, factors, impulses, jumps);
    solve_pair(model, kinematics, factors, impulses, jumps);
    for (int which = 0; which < 2; ++which)
        move_centers(model, impulses[which], jumps[which]);
}

// Efforts do not move the centres of mass.
void solve_paired_efforts(const PlanarModel& model, const Kinematics& kinematics,
                          const Factors& factors, const PerBody (&efforts)[2],
                          PerCoordinate (&jumps)[2]) {
    if (model.stretch_count > 0) {
        Loads impulses[2];
        for (int which = 0; which < 2; ++which) {
            clear_loads(model, impulses[which]);
            for (int i = 0; i < model.body_count; i += kLanes)
                store_lanes(impulses[which].effort + i, load_lanes(efforts[which] + i));
        }
        return solve_stretched_pair(model, kinematics, factors, impulses, jumps);
    }
    solve_pair(model, kinematics, factors, efforts, jumps);
}

}  // namespace cambrian
