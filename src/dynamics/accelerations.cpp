#include "dynamics/accelerations.h"

#include "dynamics/drag.h"
#include "dynamics/motors.h"

#include <cmath>

namespace cambrian {
namespace {

void add_held_force(const HeldForce& held, const Kinematics& k, Loads& loads) {
    const int a = held.body_a;
    const double arm_x = k.cosine[a] * held.point_x - k.sine[a] * held.point_y;
    const double arm_y = k.sine[a] * held.point_x + k.cosine[a] * held.point_y;
    loads.force_x[a] += held.force_x;
    loads.force_y[a] += held.force_y;
    loads.torque[a] += arm_x * held.force_y - arm_y * held.force_x;
    const int b = held.body_b;
    if (b < 0) return;
    const double back_x = k.x[a] + arm_x - k.x[b];
    const double back_y = k.y[a] + arm_y - k.y[b];
    loads.force_x[b] -= held.force_x;
    loads.force_y[b] -= held.force_y;
    loads.torque[b] -= back_x * held.force_y - back_y * held.force_x;
}

double pull_power(const HeldForce& pull, const Kinematics& k) {
    const int a = pull.body_a;
    const double arm_x = k.cosine[a] * pull.point_x - k.sine[a] * pull.point_y;
    const double arm_y = k.sine[a] * pull.point_x + k.cosine[a] * pull.point_y;
    return pull.force_x * (k.velocity_x[a] - k.spin[a] * arm_y) +
           pull.force_y * (k.velocity_y[a] + k.spin[a] * arm_x);
}

void load_motors(const PlanarModel& model, const Motion& motion, const Frame& frame, Loads& loads,
                 MotionRate& rate) {
    double net = 0.0;
    double gross = 0.0;
    loads.effort[0] = 0.0;
    for (int i = 1; i < model.body_count; ++i) {
        loads.effort[i] = frame.motor_effort[i];
        const double power = frame.motor_effort[i] * joint_rate(model, motion, frame.kinematics, i);
        net += power;
        gross += std::fabs(power);
    }
    rate.power[kMotorWork] = net;
    rate.power[kGrossMotorWork] = gross;
}

}  // namespace

void add_held_forces(const PlanarModel& model, const Forcing& forcing, const Kinematics& k,
                     Loads& loads) {
    for (int c = 0; c < forcing.contact_count; ++c)
        add_held_force(forcing.contacts[c], k, loads);
    if (!forcing.limits_active) return;
    for (int i = 1; i < model.body_count; ++i)
        loads.effort[i] += forcing.limit_effort[i];
}

void compute_loads(const PlanarModel& model, const Forcing& forcing, const Motion& motion,
                   double tick_share, Frame& frame, Loads& loads, MotionRate& rate) {
    compute_motor_efforts(model, forcing.drive, tick_share, motion, frame.kinematics,
                          frame.motor_effort);
    const Medium& medium = forcing.medium;
    for (int i = 0; i < model.body_count; ++i) {
        loads.force_x[i] = model.mass[i] * medium.gravity_x;
        loads.force_y[i] = model.mass[i] * medium.gravity_y;
        loads.torque[i] = 0.0;
    }
    load_motors(model, motion, frame, loads, rate);
    const bool dragged = medium.drag_linear > 0.0 || medium.drag_quadratic > 0.0;
    rate.power[kDragWork] = dragged ? add_drag(model, medium, frame.kinematics, loads) : 0.0;
    rate.power[kPullWork] = 0.0;
    if (forcing.pulled) {
        add_held_force(forcing.pull, frame.kinematics, loads);
        rate.power[kPullWork] = pull_power(forcing.pull, frame.kinematics);
    }
    add_held_forces(model, forcing, frame.kinematics, loads);
}

void evaluate_accelerations(const PlanarModel& model, const Forcing& forcing, const Motion& motion,
                            double tick_share, Frame& frame, MotionRate& rate) {
    Loads loads;
    compute_kinematics(model, motion, frame.kinematics);
    compute_loads(model, forcing, motion, tick_share, frame, loads, rate);
    solve_accelerations(model, frame.kinematics, loads, frame.factors, frame.response);
    for (int c = 0; c < coordinate_count(model); ++c)
        rate.acceleration[c] = frame.response.coordinate[c];
}

}  // namespace cambrian
