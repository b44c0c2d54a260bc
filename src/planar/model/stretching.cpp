#include "planar/model/stretching.h"

#include "core/assert.h"
#include "math/elementary.h"

namespace cambrian {
namespace {

bool is_stretch(const PlanarModel& model, int slot) {
    return model.motion[slot] == JointMotion::kStretch;
}

bool turns_freely(const PlanarModel& model, int body) {
    return model.parent[body] < 0 || model.motion[body] == JointMotion::kTurn;
}

void turn_stretched_bodies(const PlanarModel& model, const Motion& motion, Kinematics& k) {
    spread_stretched_spins(model, motion.speed, k.spin);
    for (int i = 0; i < round_up_to_lanes(model.body_count); ++i) {
        k.angle[i] = 0.0;
        if (i < model.body_count && !is_stretch(model, i))
            k.angle[i] = turns_freely(model, i) ? motion.position[i]
                                                : k.angle[model.parent[i]] + model.rest_angle[i];
        const SineCosine turn = sine_cosine_reduced(k.angle[i]);
        k.sine[i] = turn.sine;
        k.cosine[i] = turn.cosine;
    }
}

void grow_bodies(const PlanarModel& model, const Motion& motion, Kinematics& k) {
    for (int i = 0; i < round_up_to_lanes(model.body_count); ++i) {
        k.length_growth[i] = 1.0;
        k.width_growth[i] = 1.0;
        k.stretch_rate[i] = 0.0;
    }
    for (int i = 0; i < model.body_count; ++i) {
        const int slot = model.stretch_slot[i];
        if (slot < 0) continue;
        k.length_growth[i] = exponential(motion.position[slot]);
        k.width_growth[i] = exponential(-motion.position[slot]);
        k.stretch_rate[i] = motion.speed[slot];
    }
}

void clear_joint(Kinematics& k, int i) {
    for (PerBody* member : {&k.s_x, &k.s_y, &k.z_x, &k.z_y, &k.gamma_x, &k.gamma_y, &k.axis_x,
                            &k.axis_y, &k.y_x, &k.y_y, &k.joint_position, &k.joint_rate})
        (*member)[i] = 0.0;
}

// The slide of a joint relative to the parent, and its rate.
struct Slide {
    double length = 0.0, rate = 0.0;  // m and m/s
};

Slide measure_joint(const PlanarModel& model, const Motion& motion, Kinematics& k, int i) {
    const int p = model.parent[i];
    if (model.motion[i] == JointMotion::kFixed) return {};
    if (model.motion[i] == JointMotion::kTurn) {
        k.joint_position[i] = k.angle[i] - k.angle[p] - model.rest_angle[i];
        k.joint_rate[i] = k.spin[i] - k.spin[p];
        return {};
    }
    k.joint_position[i] = motion.position[i];
    k.joint_rate[i] = motion.speed[i];
    k.axis_x[i] = k.cosine[p] * model.axis_x[i] - k.sine[p] * model.axis_y[i];
    k.axis_y[i] = k.sine[p] * model.axis_x[i] + k.cosine[p] * model.axis_y[i];
    return {motion.position[i], motion.speed[i]};
}

// z, s, y and gamma = beta_p(r_a) - beta_i(r_c) with the terms of the slide.
void place_joint(const PlanarModel& model, const Motion& motion, Kinematics& k, int i) {
    const int p = model.parent[i];
    CAMBRIAN_TICK_ASSERT(p >= 0 && p < i, "a parent comes before its children");
    const Slide slide = measure_joint(model, motion, k, i);
    const Simd2d near = material_arm(k, p, model.parent_anchor_x[i], model.parent_anchor_y[i]);
    const Simd2d own = material_arm(k, i, model.child_anchor_x[i], model.child_anchor_y[i]);
    const Simd2d axis = {k.axis_x[i], k.axis_y[i]};
    const Simd2d arm = near + both(slide.length) * axis;
    const Simd2d lever = stretch_lever(k, p, near[0], near[1]);
    k.z_x[i] = -arm[1];
    k.z_y[i] = arm[0];
    k.s_x[i] = own[1];
    k.s_y[i] = -own[0];
    k.y_x[i] = lever[0];
    k.y_y[i] = lever[1];
    const double turn = 2.0 * k.spin[p] * slide.rate;
    const Simd2d gamma = stretch_bias(k, p, near[0], near[1]) - stretch_bias(k, i, own[0], own[1]) -
                         both(k.spin[p] * k.spin[p]) * arm + both(k.spin[i] * k.spin[i]) * own +
                         both(turn) * Simd2d{-axis[1], axis[0]};
    k.gamma_x[i] = gamma[0];
    k.gamma_y[i] = gamma[1];
}

void place_stretch(const PlanarModel& model, const Motion& motion, Kinematics& k, int slot) {
    const int b = model.parent[slot];
    k.joint_position[slot] = motion.position[slot];
    k.joint_rate[slot] = motion.speed[slot];
    if (model.parent[b] < 0) return;
    const Simd2d own = material_arm(k, b, model.child_anchor_x[b], model.child_anchor_y[b]);
    const Simd2d lever = stretch_lever(k, b, own[0], own[1]);
    k.s_x[slot] = -lever[0];
    k.s_y[slot] = -lever[1];
}

// Shifts each tree so that its mean, weighted by mass, is the given centre.
void center_trees(const PlanarModel& model, const double* center, PerBody& x, PerBody& y) {
    for (int t = 0; t < model.tree_count; ++t) {
        const int begin = model.tree_begin[t];
        const int end = model.tree_begin[t + 1];
        Simd2d shift = {center[2 * t], center[2 * t + 1]};
        for (int i = begin; i < end; ++i)
            shift -= both(model.members_of(t).share[i]) * Simd2d{x[i], y[i]};
        for (int i = begin; i < end; ++i) {
            if (is_stretch(model, i)) continue;
            x[i] += shift[0];
            y[i] += shift[1];
        }
    }
}

}  // namespace

void compute_stretched_joints(const PlanarModel& model, const Motion& motion, Kinematics& k) {
    k.deforms = true;
    turn_stretched_bodies(model, motion, k);
    grow_bodies(model, motion, k);
    for (int i = 0; i < round_up_to_lanes(model.body_count); ++i) {
        clear_joint(k, i);
        if (i >= model.body_count || model.parent[i] < 0) continue;
        if (is_stretch(model, i))
            place_stretch(model, motion, k, i);
        else
            place_joint(model, motion, k, i);
    }
}

void spread_stretched_spins(const PlanarModel& model, const PerCoordinate& rates, PerBody& spin) {
    for (int i = 0; i < round_up_to_lanes(model.body_count); ++i) {
        spin[i] = 0.0;
        if (i >= model.body_count || is_stretch(model, i)) continue;
        spin[i] = turns_freely(model, i) ? rates[i] : spin[model.parent[i]];
    }
}

void move_stretched_bodies(const PlanarModel& model, const Kinematics& k,
                           const PerCoordinate& rates, const PerBody& spin, PerBody& velocity_x,
                           PerBody& velocity_y) {
    for (int i = 0; i < round_up_to_lanes(model.body_count); ++i) {
        velocity_x[i] = 0.0;
        velocity_y[i] = 0.0;
        if (i >= model.body_count || is_stretch(model, i)) continue;
        const int p = model.parent[i];
        if (p < 0) continue;
        const int slot = model.stretch_slot[i];
        const int parent_slot = model.stretch_slot[p];
        Simd2d velocity = Simd2d{velocity_x[p], velocity_y[p]} +
                          both(spin[p]) * Simd2d{k.z_x[i], k.z_y[i]} +
                          both(spin[i]) * Simd2d{k.s_x[i], k.s_y[i]};
        if (model.motion[i] == JointMotion::kSlide)
            velocity += both(rates[i]) * Simd2d{k.axis_x[i], k.axis_y[i]};
        if (parent_slot >= 0) velocity += both(rates[parent_slot]) * Simd2d{k.y_x[i], k.y_y[i]};
        if (slot >= 0) velocity += both(rates[slot]) * Simd2d{k.s_x[slot], k.s_y[slot]};
        velocity_x[i] = velocity[0];
        velocity_y[i] = velocity[1];
    }
    center_trees(model, rates + center_of(model, 0), velocity_x, velocity_y);
}

void place_stretched_bodies(const PlanarModel& model, const Motion& motion, Kinematics& k) {
    for (int i = 0; i < round_up_to_lanes(model.body_count); ++i) {
        k.x[i] = 0.0;
        k.y[i] = 0.0;
        if (i >= model.body_count || is_stretch(model, i) || model.parent[i] < 0) continue;
        const int p = model.parent[i];
        k.x[i] = k.x[p] + k.z_y[i] + k.s_y[i];
        k.y[i] = k.y[p] - k.z_x[i] - k.s_x[i];
    }
    center_trees(model, motion.position + center_of(model, 0), k.x, k.y);
}

double stretched_kinetic_energy(const PlanarModel& model, const Kinematics& k) {
    double energy = 0.0;
    for (int i = 0; i < model.body_count; ++i) {
        if (is_stretch(model, i)) continue;
        energy += model.mass[i] *
                      (k.velocity_x[i] * k.velocity_x[i] + k.velocity_y[i] * k.velocity_y[i]) +
                  present_inertia(model, k, i) *
                      (k.spin[i] * k.spin[i] + k.stretch_rate[i] * k.stretch_rate[i]);
    }
    return 0.5 * energy;
}

}  // namespace cambrian
