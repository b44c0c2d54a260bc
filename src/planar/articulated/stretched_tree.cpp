
#include "core/assert.h"
#include "planar/articulated/articulated_body.h"
#include "planar/model/stretching.h"

namespace cambrian {
namespace {

// The matrix A, symmetric.
struct Symmetric {
    double xx = 0.0, xy = 0.0, yy = 0.0;

    CAMBRIAN_INLINE Simd2d times(const Simd2d& v) const {
        return Simd2d{xx * v[0] + xy * v[1], xy * v[0] + yy * v[1]};
    }
    CAMBRIAN_INLINE void add(const Symmetric& other) {
        xx += other.xx;
        xy += other.xy;
        yy += other.yy;
    }
    // Subtracts v v' scale.
    CAMBRIAN_INLINE void take_square(const Simd2d& v, double scale) {
        xx -= v[0] * v[0] * scale;
        xy -= v[0] * v[1] * scale;
        yy -= v[1] * v[1] * scale;
    }
};

// The articulated inertia [[A, h], [h', j]] of a subtree about its body's centre.
struct SubtreeInertia {
    Symmetric a;
    Simd2d h = {};
    double j = 0.0;
};

// The row of a body's stretch: its coupling to the velocity of the centre and to the spin, and its
// mass.
struct StretchRow {
    Simd2d to_center = {};
    double to_spin = 0.0;
    double mass = 0.0;
};

// What remains of a child's inertia behind its joint: the force at the joint and the torque by
// which the parent accelerates it.
struct Handed {
    Symmetric a;
    Simd2d turn = {};
    double spin = 0.0;
};

// The force and torque on a joint by the accelerations at zero coordinate accelerations.
struct JointBias {
    Simd2d force = {};
    double torque = 0.0;
};

// Loads on the way from the leaves to the root, about the centres; of a stretch in its slot.
struct PassedLoads {
    Simd2d force[kMaxBodies];
    PerBody torque, stretch;
};

CAMBRIAN_INLINE Simd2d s_of(const Kinematics& k, int i) {
    return Simd2d{k.s_x[i], k.s_y[i]};
}
CAMBRIAN_INLINE Simd2d z_of(const Kinematics& k, int i) {
    return Simd2d{k.z_x[i], k.z_y[i]};
}
CAMBRIAN_INLINE Simd2d y_of(const Kinematics& k, int i) {
    return Simd2d{k.y_x[i], k.y_y[i]};
}
CAMBRIAN_INLINE Simd2d axis_of(const Kinematics& k, int i) {
    return Simd2d{k.axis_x[i], k.axis_y[i]};
}
CAMBRIAN_INLINE Simd2d gamma_of(const Kinematics& k, int i) {
    return Simd2d{k.gamma_x[i], k.gamma_y[i]};
}
CAMBRIAN_INLINE Simd2d w_of(const Factors& factors, int i) {
    return Simd2d{factors.w_x[i], factors.w_y[i]};
}

// Eliminates the joints and stretches from the leaves to the roots.
class Elimination {
public:
    Elimination(const PlanarModel& model, const Kinematics& kinematics, Factors& factors)
        : model_(model), k_(kinematics), factors_(factors) {}

    void run(JointBias* biases) {
        for (int i = 0; i < model_.body_count; ++i)
            start(i);
        for (int tree = 0; tree < model_.tree_count; ++tree) {
            const int root = model_.tree_begin[tree];
            for (int i = model_.tree_begin[tree + 1] - 1; i > root; --i) {
                if (model_.motion[i] == JointMotion::kStretch) {
                    eliminate_stretch(i);
                    continue;
                }
                const Handed handed = eliminate_joint(i);
                biases[i] = {handed.a.times(gamma_of(k_, i)), dot(handed.turn, gamma_of(k_, i))};
                add_to_parent(i, handed);
            }
            const SubtreeInertia& all = inertias_[root];
            factors_.root[tree] =
                invert_inertia(all.a.xx, all.a.xy, all.a.yy, all.h[0], all.h[1], all.j);
        }
    }

private:
    void start(int i) {
        if (model_.motion[i] == JointMotion::kStretch) return;
        const int slot = model_.stretch_slot[i];
        inertias_[i].a = Symmetric{model_.mass[i], 0.0, model_.mass[i]};
        inertias_[i].j = model_.inertia[i];
        if (slot < 0) return;
        const InertiaParts parts = inertia_parts(model_, k_, i);
        inertias_[i].j = parts.length + parts.width;
        rows_[slot].mass = parts.length + parts.width;
    }

    void keep(int i, const Simd2d& w, double w_3, double inverse_d) {
        factors_.w_x[i] = w[0];
        factors_.w_y[i] = w[1];
        factors_.w_3[i] = w_3;
        factors_.inverse_d[i] = inverse_d;
    }

    void eliminate_stretch(int slot) {
        SubtreeInertia& body = inertias_[model_.parent[slot]];
        const StretchRow& row = rows_[slot];
        const Simd2d s = s_of(k_, slot);
        const Simd2d w = row.to_center + body.a.times(s);
        const double w_3 = row.to_spin + dot(body.h, s);
        const double inverse_d =
            1.0 / (row.mass + dot(row.to_center + w, s) + factors_.damping[slot]);
        body.a.take_square(w, inverse_d);
        body.h -= w * both(w_3 * inverse_d);
        body.j -= w_3 * w_3 * inverse_d;
        keep(slot, w, w_3, inverse_d);
    }

    Handed eliminate_joint(int i) {
        const SubtreeInertia& c = inertias_[i];
        const Simd2d s = s_of(k_, i);
        const double damping = factors_.damping[i];
        const Simd2d h = c.h + c.a.times(s);
        const double j = c.j + dot(c.h + h, s);
        Handed handed{c.a, h, j};
        if (model_.motion[i] == JointMotion::kFixed) {
            keep(i, Simd2d{}, 0.0, 0.0);
        } else if (model_.motion[i] == JointMotion::kTurn) {
            const double inverse_d = 1.0 / (j + damping);
            const double share = damping * inverse_d;
            handed.a.take_square(h, inverse_d);
            handed.turn = h * both(share);
            handed.spin = damping * (1.0 - share);
            keep(i, h, 0.0, inverse_d);
        } else {
            const Simd2d axis = axis_of(k_, i);
            const Simd2d w = c.a.times(axis);
            const double w_3 = dot(h, axis);
            const double inverse_d = 1.0 / (dot(axis, w) + damping);
            handed.a.take_square(w, inverse_d);
            handed.turn -= w * both(w_3 * inverse_d);
            handed.spin -= w_3 * w_3 * inverse_d;
            keep(i, w, w_3, inverse_d);
        }
        return handed;
    }

    void add_to_parent(int i, const Handed& handed) {
        const int p = model_.parent[i];
        const int slot = model_.stretch_slot[p];
        const Simd2d z = z_of(k_, i);
        const Simd2d by_spin = handed.a.times(z);
        SubtreeInertia& parent = inertias_[p];
        parent.a.add(handed.a);
        parent.h += by_spin + handed.turn;
        parent.j += dot(z, by_spin) + 2.0 * dot(z, handed.turn) + handed.spin;
        if (slot < 0) return;
        const Simd2d y = y_of(k_, i);
        const Simd2d by_stretch = handed.a.times(y);
        StretchRow& row = rows_[slot];
        row.to_center += by_stretch;
        row.to_spin += dot(y, by_spin + handed.turn);
        row.mass += dot(y, by_stretch);
    }

    const PlanarModel& model_;
    const Kinematics& k_;
    Factors& factors_;
    SubtreeInertia inertias_[kMaxBodies];
    StretchRow rows_[kMaxBodies];
};

// Passes the loads of a slot to its parent and returns u, the load on its coordinate.
CAMBRIAN_INLINE double pass_loads(const PlanarModel& model, const Kinematics& k,
                                  const Factors& factors, double effort, const JointBias& bias,
                                  int i, PassedLoads& loads) {
    const int p = model.parent[i];
    const Simd2d w = w_of(factors, i);
    CAMBRIAN_TICK_ASSERT(p >= 0 && p < i, "a parent comes before its children");
    if (model.motion[i] == JointMotion::kStretch) {
        const double u = effort + loads.stretch[i] + dot(s_of(k, i), loads.force[p]);
        const double share = u * factors.inverse_d[i];
        loads.force[p] -= w * both(share);
        loads.torque[p] -= factors.w_3[i] * share;
        return u;
    }
    const Simd2d f = loads.force[i];
    const double t = loads.torque[i] + dot(s_of(k, i), f);
    const bool turns = model.motion[i] == JointMotion::kTurn;
    const double u = effort + (turns ? t : dot(axis_of(k, i), f));
    const double share = u * factors.inverse_d[i];
    const Simd2d passed = f - w * both(share) - bias.force;
    const double turn = turns ? factors.damping[i] * share - effort : t - factors.w_3[i] * share;
    loads.force[p] += passed;
    loads.torque[p] += dot(z_of(k, i), passed) + turn - bias.torque;
    if (const int slot = model.stretch_slot[p]; slot >= 0)
        loads.stretch[slot] += dot(y_of(k, i), passed);
    return u;
}

// Computes a slot's response from its parent's; gamma is 0 for impulses.
CAMBRIAN_INLINE void follow_stretched_parent(const PlanarModel& model, const Kinematics& k,
                                             const Factors& factors, double u, const Simd2d& gamma,
                                             int i, BodyResponse& response) {
    const int p = model.parent[i];
    const double spin = response.spin[p];
    Simd2d a = {response.x[p], response.y[p]};
    if (model.motion[i] == JointMotion::kStretch) {
        const double rate =
            (u - dot(w_of(factors, i), a) - factors.w_3[i] * spin) * factors.inverse_d[i];
        a += both(rate) * s_of(k, i);
        response.x[p] = a[0];
        response.y[p] = a[1];
        response.x[i] = 0.0;
        response.y[i] = 0.0;
        response.spin[i] = 0.0;
        response.coordinate[i] = rate;
        return;
    }
    a += both(spin) * z_of(k, i) + gamma;
    if (const int slot = model.stretch_slot[p]; slot >= 0)
        a += both(response.coordinate[slot]) * y_of(k, i);
    const double rest = u - dot(w_of(factors, i), a);
    double turn = spin;
    double rate = 0.0;
    if (model.motion[i] == JointMotion::kTurn) {
        turn = (rest + factors.damping[i] * spin) * factors.inverse_d[i];
        rate = turn;
    } else if (model.motion[i] == JointMotion::kSlide) {
        rate = (rest - factors.w_3[i] * spin) * factors.inverse_d[i];
        a += both(rate) * axis_of(k, i);
    }
    a += both(turn) * s_of(k, i);
    response.x[i] = a[0];
    response.y[i] = a[1];
    response.spin[i] = turn;
    response.coordinate[i] = rate;
}

// Solves for the responses to loads on the bodies and efforts of the slots.
void respond_to_loads(const PlanarModel& model, const Kinematics& k, const Factors& factors,
                      const PerBody& efforts, const JointBias* biases, PassedLoads& loads,
                      BodyResponse& response) {
    PerBody u;
    for (int tree = 0; tree < model.tree_count; ++tree) {
        const int root = model.tree_begin[tree];
        const int end = model.tree_begin[tree + 1];
        for (int i = end - 1; i > root; --i)
            u[i] = pass_loads(model, k, factors, efforts[i],
                              biases == nullptr ? JointBias{} : biases[i], i, loads);
        solve_root(factors.root[tree], root, loads.force[root], loads.torque[root], response);
        for (int i = root + 1; i < end; ++i) {
            const Simd2d gamma = biases == nullptr ? Simd2d{} : gamma_of(k, i);
            follow_stretched_parent(model, k, factors, u[i], gamma, i, response);
        }
    }
}

void start_loads(const PlanarModel& model, const Loads& loads, PassedLoads& passed) {
    for (int i = 0; i < model.body_count; ++i) {
        passed.force[i] = Simd2d{loads.force_x[i], loads.force_y[i]};
        passed.torque[i] = loads.torque[i];
        passed.stretch[i] = 0.0;
    }
}

// Adds the velocity terms of the bodies themselves: spin slows as a body lengthens, and the
// centrifugal force lengthens it.
void add_own_terms(const PlanarModel& model, const Kinematics& k, PassedLoads& passed) {
    for (int i = 0; i < model.body_count; ++i) {
        const int slot = model.stretch_slot[i];
        if (slot < 0) continue;
        const InertiaParts parts = inertia_parts(model, k, i);
        const double difference = parts.length - parts.width;
        const double spin = k.spin[i];
        const double rate = k.stretch_rate[i];
        passed.torque[i] -= 2.0 * difference * spin * rate;
        passed.stretch[slot] += difference * (spin * spin - rate * rate);
    }
}

}  // namespace

void solve_stretched_accelerations(const PlanarModel& model, const Kinematics& kinematics,
                                   const Loads& loads, Factors& factors, BodyResponse& response) {
    JointBias biases[kMaxBodies];
    PassedLoads passed;
    Elimination(model, kinematics, factors).run(biases);
    start_loads(model, loads, passed);
    add_own_terms(model, kinematics, passed);
    respond_to_loads(model, kinematics, factors, loads.effort, biases, passed, response);
    move_centers(model, loads, response.coordinate);
}

void solve_stretched_impulse(const PlanarModel& model, const Kinematics& kinematics,
                             const Factors& factors, const Loads& impulses,
                             BodyResponse& response) {
    PassedLoads passed;
    start_loads(model, impulses, passed);
    respond_to_loads(model, kinematics, factors, impulses.effort, nullptr, passed, response);
    move_centers(model, impulses, response.coordinate);
}

}  // namespace cambrian
