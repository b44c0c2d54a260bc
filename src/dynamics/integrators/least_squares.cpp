// The reference mode: every body has three coordinates of its own, the classical fourth-order
// Runge-Kutta method moves them under constraint forces found by dense least squares, and at the
// step's end what little the joints came apart is projected away.

#include "dynamics/builtin_integrators.h"
#include "dynamics/least_squares_dynamics.h"

namespace cambrian {
namespace {

constexpr double kTimeConstant = 1.0 / 20;  // s

struct FreeBodies {
    Eigen::VectorXd place, speed;  // x, y, angle of every body
};

FreeBodies separate(int bodies, const Kinematics& k) {
    FreeBodies free{Eigen::VectorXd(3 * bodies), Eigen::VectorXd(3 * bodies)};
    for (int i = 0; i < bodies; ++i) {
        free.place.segment<3>(3 * i) << k.x[i], k.y[i], k.angle[i];
        free.speed.segment<3>(3 * i) << k.velocity_x[i], k.velocity_y[i], k.spin[i];
    }
    return free;
}

void place_bodies(int bodies, const FreeBodies& free, Kinematics& k) {
    for (int i = 0; i < bodies; ++i) {
        k.x[i] = free.place(3 * i);
        k.y[i] = free.place(3 * i + 1);
        k.angle[i] = free.place(3 * i + 2);
        const SineCosine turn = sine_cosine(k.angle[i]);
        k.sine[i] = turn.sine;
        k.cosine[i] = turn.cosine;
        k.velocity_x[i] = free.speed(3 * i);
        k.velocity_y[i] = free.speed(3 * i + 1);
        k.spin[i] = free.speed(3 * i + 2);
    }
}

// Length of a linear joint and its rate.
void measure_slide(const PlanarModel& model, const Kinematics& k, int i, Motion& motion) {
    const int p = model.parent[i];
    const double axis_x = k.cosine[p] * model.axis_x[i] - k.sine[p] * model.axis_y[i];
    const double axis_y = k.sine[p] * model.axis_x[i] + k.cosine[p] * model.axis_y[i];
    const auto anchor = [&](int body, double x, double y, double& world_x, double& world_y) {
        world_x = k.cosine[body] * x - k.sine[body] * y;
        world_y = k.sine[body] * x + k.cosine[body] * y;
    };
    double parent_x = 0.0;
    double parent_y = 0.0;
    double child_x = 0.0;
    double child_y = 0.0;
    anchor(p, model.parent_anchor_x[i], model.parent_anchor_y[i], parent_x, parent_y);
    anchor(i, model.child_anchor_x[i], model.child_anchor_y[i], child_x, child_y);
    const double delta_x = k.x[i] + child_x - k.x[p] - parent_x;
    const double delta_y = k.y[i] + child_y - k.y[p] - parent_y;
    const double rate_x =
        k.velocity_x[i] - k.spin[i] * child_y - k.velocity_x[p] + k.spin[p] * parent_y;
    const double rate_y =
        k.velocity_y[i] + k.spin[i] * child_x - k.velocity_y[p] - k.spin[p] * parent_x;
    motion.position[coordinate_of(i)] = axis_x * delta_x + axis_y * delta_y;
    motion.speed[coordinate_of(i)] =
        axis_x * rate_x + axis_y * rate_y + k.spin[p] * (axis_x * delta_y - axis_y * delta_x);
}

// The joints' coordinates of bodies that may have come apart a little.
void join(const PlanarModel& model, const Kinematics& k, Motion& motion) {
    for (int axis = 0; axis < 2; ++axis) {
        motion.position[axis] = 0.0;
        motion.speed[axis] = 0.0;
    }
    for (int i = 0; i < model.body_count; ++i) {
        const double share = model.mass[i] / model.total_mass;
        motion.position[0] += share * k.x[i];
        motion.position[1] += share * k.y[i];
        motion.speed[0] += share * k.velocity_x[i];
        motion.speed[1] += share * k.velocity_y[i];
        motion.position[coordinate_of(i)] = k.angle[i];
        motion.speed[coordinate_of(i)] = k.spin[i];
        if (model.joint[i] == JointType::kLinear) measure_slide(model, k, i, motion);
    }
}

void attempt_least_squares_step(const MotionSystem& system, const StepRequest& request,
                                Frame& frame, StepResult& result) {
    constexpr double kNode[4] = {0.0, 0.5, 0.5, 1.0};
    constexpr double kWeight[4] = {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6};
    const PlanarModel& model = system.model;
    const int bodies = model.body_count;
    const double h = request.length;
    LeastSquaresDynamics dynamics(model, kTimeConstant);
    Frame stage;
    compute_kinematics(model, request.start, stage.kinematics);
    const FreeBodies start = separate(bodies, stage.kinematics);
    FreeBodies rate{start.speed, Eigen::VectorXd::Zero(3 * bodies)};
    FreeBodies sum{Eigen::VectorXd::Zero(3 * bodies), Eigen::VectorXd::Zero(3 * bodies)};
    for (int w = 0; w < kWorkCount; ++w)
        result.end.work[w] = request.start.work[w];
    for (int s = 0; s < 4; ++s) {
        const double reach = kNode[s] * h;
        const FreeBodies moved{start.place + reach * rate.place, start.speed + reach * rate.speed};
        place_bodies(bodies, moved, stage.kinematics);
        Motion motion;
        join(model, stage.kinematics, motion);
        Loads loads;
        MotionRate powers;
        compute_loads(model, system.forcing, motion, (request.time + reach) / system.tick_length,
                      stage, loads, powers);
        rate = {moved.speed, dynamics.solve(stage.kinematics, loads)};
        sum.place += kWeight[s] * rate.place;
        sum.speed += kWeight[s] * rate.speed;
        for (int w = 0; w < kWorkCount; ++w)
            result.end.work[w] += h * kWeight[s] * powers.power[w];
    }
    place_bodies(bodies, {start.place + h * sum.place, start.speed + h * sum.speed},
                 stage.kinematics);
    join(model, stage.kinematics, result.end);
    system.evaluate(result.end, request.time + h, frame, result.end_rate);
    result.error = 0.0;
    result.evaluations = 5;
}

}  // namespace

IntegratorKind least_squares() {
    return {"least-squares", attempt_least_squares_step, 1.0 / 4, 1.0 / 240};
}

}  // namespace cambrian
