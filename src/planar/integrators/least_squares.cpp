// The reference integrator (planar/README.md 18): every body has three coordinates. The classical
// Runge-Kutta method of fourth order moves them under constraint forces found by dense least
// squares. At the step's end the small gaps of joints are projected away.

#include "planar/articulated/least_squares_dynamics.h"
#include "planar/integrators/builtin_integrators.h"

namespace cambrian {
namespace {

constexpr double kTimeConstant = 1.0 / 20;  // s
constexpr double kNode[4] = {0.0, 0.5, 0.5, 1.0};
constexpr double kWeight[4] = {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6};

struct FreeBodies {
    Eigen::VectorXd place, speed;  // x, y, angle of every body
};

FreeBodies separate(Eigen::Index bodies, const Kinematics& k) {
    FreeBodies free{Eigen::VectorXd(3 * bodies), Eigen::VectorXd(3 * bodies)};
    for (Eigen::Index i = 0; i < bodies; ++i) {
        free.place.segment<3>(3 * i) << k.x[i], k.y[i], k.angle[i];
        free.speed.segment<3>(3 * i) << k.velocity_x[i], k.velocity_y[i], k.spin[i];
    }
    return free;
}

void place_bodies(Eigen::Index bodies, const FreeBodies& free, Kinematics& k) {
    for (Eigen::Index i = 0; i < bodies; ++i) {
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

// Length of a prismatic joint and its rate.
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
    motion.position[i] = axis_x * delta_x + axis_y * delta_y;
    motion.speed[i] =
        axis_x * rate_x + axis_y * rate_y + k.spin[p] * (axis_x * delta_y - axis_y * delta_x);
}

// Computes the coordinates of bodies whose joints may have small gaps.
void join(const PlanarModel& model, Kinematics& k, Motion& motion) {
    for (int t = 0; t < model.tree_count; ++t) {
        const int center = center_of(model, t);
        for (int axis = 0; axis < 2; ++axis) {
            motion.position[center + axis] = 0.0;
            motion.speed[center + axis] = 0.0;
        }
        for (int i = model.tree_begin[t]; i < model.tree_begin[t + 1]; ++i) {
            const double share = model.members_of(t).share[i];
            motion.position[center] += share * k.x[i];
            motion.position[center + 1] += share * k.y[i];
            motion.speed[center] += share * k.velocity_x[i];
            motion.speed[center + 1] += share * k.velocity_y[i];
        }
    }
    for (int i = 0; i < model.body_count; ++i) {
        motion.position[i] = k.angle[i];
        motion.speed[i] = k.spin[i];
        const int p = model.parent_slot[i];
        const bool is_prismatic = model.motion[i] == JointMotion::kSlide;
        if (is_prismatic) measure_slide(model, k, i, motion);
        k.joint_position[i] =
            is_prismatic ? motion.position[i] : k.angle[i] - k.angle[p] - model.rest_angle[i];
        k.joint_rate[i] = is_prismatic ? motion.speed[i] : k.spin[i] - k.spin[p];
    }
}

void attempt_least_squares_step(const MotionSystem& system, const StepRequest& request,
                                EvaluationCache& cache, StepResult& result) {
    const PlanarModel& model = system.model;
    const Eigen::Index bodies = model.body_count;
    const double h = request.length;
    LeastSquaresDynamics dynamics(model, kTimeConstant);
    EvaluationCache stage = {};
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
        MotionRate powers;
        compute_loads(model, system.forcing, {(request.time + reach) / system.tick_length}, stage,
                      powers);
        rate = {moved.speed, dynamics.solve(stage.kinematics, stage.loads)};
        sum.place += kWeight[s] * rate.place;
        sum.speed += kWeight[s] * rate.speed;
        for (int w = 0; w < kWorkCount; ++w)
            result.end.work[w] += h * kWeight[s] * powers.power[w];
    }
    place_bodies(bodies, {start.place + h * sum.place, start.speed + h * sum.speed},
                 stage.kinematics);
    join(model, stage.kinematics, result.end);
    system.evaluate(result.end, request.time + h, EvaluationDetail::kEverything, cache,
                    result.end_rate);
    result.error = 0.0;
    result.evaluations = 5;
}

}  // namespace

void add_least_squares(IntegratorRegistry& integrators) {
    integrators.add(
        {"least-squares", "Least squares", attempt_least_squares_step, 4, 1.0 / 240, false, false});
}

}  // namespace cambrian
