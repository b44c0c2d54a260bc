#include "planar/evaluation/accelerations.h"

#include "core/assert.h"
#include "planar/forces/drag.h"
#include "planar/model/stretching.h"

namespace cambrian {
namespace {

// Adds the effort of a force at this world offset from a body's centre on the body's stretch.
void add_stretch_effort(const PlanarModel& model, const Kinematics& k, int body, const Simd2d& arm,
                        const Simd2d& force, Loads& loads) {
    const int slot = model.stretch_slot[body];
    if (slot >= 0) loads.effort[slot] += dot(stretch_lever(k, body, arm[0], arm[1]), force);
}

void add_held_force(const PlanarModel& model, const HeldForce& held, const Kinematics& k,
                    Loads& loads) {
    const int a = held.body_a;
    CAMBRIAN_TICK_ASSERT(a >= 0 && held.body_b < kMaxBodies, "a force on a body");
    const Simd2d arm = material_arm(k, a, held.point_x, held.point_y);
    const double arm_x = arm[0];
    const double arm_y = arm[1];
    loads.force_x[a] += held.force_x;
    loads.force_y[a] += held.force_y;
    loads.torque[a] += arm_x * held.force_y - arm_y * held.force_x;
    const Simd2d force = {held.force_x, held.force_y};
    if (k.deforms) add_stretch_effort(model, k, a, arm, force, loads);
    const int b = held.body_b;
    if (b < 0) return;
    const double back_x = k.x[a] + arm_x - k.x[b];
    const double back_y = k.y[a] + arm_y - k.y[b];
    loads.force_x[b] -= held.force_x;
    loads.force_y[b] -= held.force_y;
    loads.torque[b] -= back_x * held.force_y - back_y * held.force_x;
    if (k.deforms) add_stretch_effort(model, k, b, Simd2d{back_x, back_y}, -force, loads);
}

double pull_power(const HeldForce& pull, const Kinematics& k) {
    const int a = pull.body_a;
    const Simd2d arm = material_arm(k, a, pull.point_x, pull.point_y);
    double power = pull.force_x * (k.velocity_x[a] - k.spin[a] * arm[1]) +
                   pull.force_y * (k.velocity_y[a] + k.spin[a] * arm[0]);
    if (k.deforms)
        power += dot(stretch_velocity(k, a, arm[0], arm[1]), Simd2d{pull.force_x, pull.force_y});
    return power;
}

CAMBRIAN_INLINE bool is_dragged(const Medium& medium) {
    return medium.drag_linear > 0.0 || medium.drag_quadratic > 0.0;
}

// Returns the torque of all loads about the centre of mass of the only tree, N m. Gravity has none.
CAMBRIAN_INLINE double torque_about_center(const PlanarModel& model, const Kinematics& k,
                                           const Loads& loads) {
    const double* share = model.members_of(0).share;
    Simd4dVector center = {};
    Simd4dVector force = {};
    Simd4d torque = {};
    for (int i = 0; i < model.body_count; i += kLanes) {
        const Simd4d x = load_lanes(k.x + i);
        const Simd4d y = load_lanes(k.y + i);
        const Simd4d force_x = load_lanes(loads.force_x + i);
        const Simd4d force_y = load_lanes(loads.force_y + i);
        add_weighted(share + i, x, y, center);
        force.x += force_x;
        force.y += force_y;
        torque += x * force_y - y * force_x + load_lanes(loads.torque + i);
    }
    return sum_of(torque) -
           (sum_of(center.x) * sum_of(force.y) - sum_of(center.y) * sum_of(force.x));
}

CAMBRIAN_INLINE bool is_turned(const PlanarModel& model, const Forcing& forcing) {
    return model.tree_count == 1 && (is_dragged(forcing.medium) || !forcing.pulls.empty());
}

CAMBRIAN_INLINE bool holds_pairs(const Forcing& forcing) {
    if (forcing.held == nullptr) return false;
    for (int c = 0; c < forcing.held->contact_count; ++c) {
        if (forcing.held->contacts[c].body_b >= 0) return true;
    }
    return false;
}

}  // namespace

void add_held_forces(const PlanarModel& model, const HeldForces& held, const Kinematics& k,
                     Loads& loads) {
    for (int c = 0; c < held.contact_count; ++c)
        add_held_force(model, held.contacts[c], k, loads);
    if (!held.limits_active) return;
    for (int i = 1; i < model.body_count; ++i)
        loads.effort[i] += held.limit_effort[i];
}

void compute_loads(const PlanarModel& model, const Forcing& forcing, const EvaluationPoint& point,
                   EvaluationCache& cache, MotionRate& rate) {
    CAMBRIAN_TICK_ASSERT(point.tick_share >= 0.0 && point.tick_share <= 1.0 + 1e-9,
                         "a moment of the tick");
    Loads& loads = cache.loads;
    MotorPower motors;
    if (point.implicit == nullptr)
        motors = compute_motor_efforts(model, forcing.drive, point.tick_share, cache.kinematics,
                                       cache.motor_effort);
    else
        compute_implicit_efforts(model, forcing.drive, point.tick_share, *point.implicit,
                                 cache.kinematics, cache.motor_effort, cache.motor_damping);
    rate.power[kMotorWork] = motors.net;
    rate.power[kGrossMotorWork] = motors.gross;
    const Medium& medium = forcing.medium;
    const double gravity_x = medium.gravity_x;
    const double gravity_y = medium.gravity_y;
    for (int i = 0; i < model.body_count; i += kLanes) {
        const Simd4d mass = load_lanes(model.mass + i);
        store_lanes(loads.force_x + i, mass * gravity_x);
        store_lanes(loads.force_y + i, mass * gravity_y);
        store_lanes(loads.torque + i, Simd4d{});
        store_lanes(loads.effort + i, load_lanes(cache.motor_effort + i));
    }
    rate.power[kDragWork] =
        is_dragged(medium) ? add_drag(model, medium, cache.kinematics, loads) : 0.0;
    rate.power[kPullWork] = 0.0;
    for (const HeldForce& pull : forcing.pulls) {
        add_held_force(model, pull, cache.kinematics, loads);
        rate.power[kPullWork] += pull_power(pull, cache.kinematics);
    }
    rate.power[kSpinGiven] =
        is_turned(model, forcing) ? torque_about_center(model, cache.kinematics, loads) : 0.0;
    if (forcing.held != nullptr) add_held_forces(model, *forcing.held, cache.kinematics, loads);
}

namespace {

// This is a separate function, so that the choice between the two costs little.
[[gnu::noinline]] void evaluate_tree(const PlanarModel& model, const Forcing& forcing,
                                     const Motion& motion, const EvaluationPoint& point,
                                     EvaluationCache& cache, MotionRate& rate) {
    cache.has_centers = true;
    cache.has_joint_geometry = true;
    cache.is_factored = true;
    cache.is_inverted = false;
    const bool all = point.detail == EvaluationDetail::kEverything;
    compute_joints(model, motion, cache.kinematics);
    if (all || !forcing.pulls.empty() || is_dragged(forcing.medium))
        compute_velocities(model, motion, cache.kinematics);
    if (all || is_turned(model, forcing) || holds_pairs(forcing))
        compute_places(model, motion, cache.kinematics);
    compute_loads(model, forcing, point, cache, rate);
    if (point.implicit == nullptr)
        solve_accelerations(model, cache.kinematics, cache.loads, cache.factors, cache.response);
    else
        solve_damped_accelerations(model, cache.kinematics, cache.loads, cache.motor_damping,
                                   cache.factors, cache.response);
    const int count = coordinate_count(model);
    for (int c = 0; c < count; c += kLanes)
        store_lanes(rate.acceleration + c, load_lanes(cache.response.coordinate + c));
}

}  // namespace

void evaluate_accelerations(const PlanarModel& model, const Forcing& forcing, const Motion& motion,
                            const EvaluationPoint& point, EvaluationCache& cache,
                            MotionRate& rate) {
    if (is_dense(model, forcing)) {
        evaluate_dense(model, forcing, motion, point, cache, rate);
    } else {
        evaluate_tree(model, forcing, motion, point, cache, rate);
    }
}

void find_centers(const PlanarModel& model, EvaluationCache& cache) {
    if (cache.has_centers) return;
    cache.has_centers = true;
    accelerate_dense_centers(model, cache.kinematics, cache.response);
}

void complete_cache(const PlanarModel& model, EvaluationCache& cache) {
    find_centers(model, cache);
    if (cache.is_factored) return;
    cache.is_factored = true;
    if (!cache.has_joint_geometry) compute_joint_geometry(model, cache.kinematics);
    cache.has_joint_geometry = true;
    factorize(model, cache.kinematics, cache.factors);
}

}  // namespace cambrian
