// Accelerations of trees with deformable bodies against a dense solution of Lagrange's equations.
// The places of the bodies are written down once, as truncated Taylor series in time; Jacobians and
// velocity terms follow from their first and second derivatives.

#include "planar/model/stretching.h"

#include "planar/articulated/articulated_body.h"
#include "planar/bodies.h"
#include "planar/model_building.h"
#include "support/catch.h"

#include <Eigen/Dense>

#include <cmath>

using namespace cambrian;

namespace {

// A number with its first and second derivative by time.
struct Series {
    double value = 0.0, rate = 0.0, bend = 0.0;

    friend Series operator+(const Series& a, const Series& b) {
        return {a.value + b.value, a.rate + b.rate, a.bend + b.bend};
    }
    friend Series operator-(const Series& a, const Series& b) {
        return {a.value - b.value, a.rate - b.rate, a.bend - b.bend};
    }
    friend Series operator*(const Series& a, const Series& b) {
        return {a.value * b.value, a.rate * b.value + a.value * b.rate,
                a.bend * b.value + 2.0 * a.rate * b.rate + a.value * b.bend};
    }
};

Series constant(double value) {
    return {value, 0.0, 0.0};
}

// f(x) from the values of f, f' and f'' at x.
Series composed(double f, double slope, double bend, const Series& x) {
    return {f, slope * x.rate, bend * x.rate * x.rate + slope * x.bend};
}

Series exp_of(const Series& x) {
    const double e = std::exp(x.value);
    return composed(e, e, e, x);
}
Series sin_of(const Series& x) {
    return composed(std::sin(x.value), std::cos(x.value), -std::sin(x.value), x);
}
Series cos_of(const Series& x) {
    return composed(std::cos(x.value), -std::sin(x.value), -std::cos(x.value), x);
}

struct Point {
    Series x, y;
};

struct Places {
    std::vector<Point> center;
    std::vector<Series> angle;
};

// The places of all bodies while the coordinates change at constant rates.
Places places_of(const PlanarModel& model, const Motion& motion, const Eigen::VectorXd& rates) {
    const auto coordinate = [&](int c) { return Series{motion.position[c], rates(c), 0.0}; };
    const auto count = static_cast<std::size_t>(model.body_count);
    Places places{std::vector<Point>(count), std::vector<Series>(count)};
    const auto material = [&](int body, double x, double y) {
        const int slot = model.stretch_slot[body];
        const Series s = slot < 0 ? constant(0.0) : coordinate(slot);
        const Series along = exp_of(s) * constant(x);
        const Series across = exp_of(constant(0.0) - s) * constant(y);
        const Series& angle = places.angle[static_cast<std::size_t>(body)];
        return Point{cos_of(angle) * along - sin_of(angle) * across,
                     sin_of(angle) * along + cos_of(angle) * across};
    };
    for (int i = 0; i < model.body_count; ++i) {
        const auto at = static_cast<std::size_t>(i);
        if (model.motion[i] == JointMotion::kStretch) continue;
        const int p = model.parent[i];
        const bool turns = p < 0 || model.motion[i] == JointMotion::kTurn;
        const auto above = static_cast<std::size_t>(std::max(p, 0));
        places.angle[at] =
            turns ? coordinate(i) : places.angle[above] + constant(model.rest_angle[i]);
        if (p < 0) continue;
        const Point near = material(p, model.parent_anchor_x[i], model.parent_anchor_y[i]);
        const Point own = material(i, model.child_anchor_x[i], model.child_anchor_y[i]);
        Point center{places.center[above].x + near.x - own.x,
                     places.center[above].y + near.y - own.y};
        if (model.motion[i] == JointMotion::kSlide) {
            const Series direction =
                places.angle[above] + constant(std::atan2(model.axis_y[i], model.axis_x[i]));
            center.x = center.x + coordinate(i) * cos_of(direction);
            center.y = center.y + coordinate(i) * sin_of(direction);
        }
        places.center[at] = center;
    }
    Point mean{coordinate(model.body_count), coordinate(model.body_count + 1)};
    for (std::size_t i = 0; i < count; ++i) {
        mean.x = mean.x - constant(model.members_of(0).share[i]) * places.center[i].x;
        mean.y = mean.y - constant(model.members_of(0).share[i]) * places.center[i].y;
    }
    for (Point& center : places.center) {
        center.x = center.x + mean.x;
        center.y = center.y + mean.y;
    }
    return places;
}

struct DeformingState {
    PlanarModel model;
    Motion motion;
    Kinematics kinematics;
    Loads loads;
};

DeformingState random_deforming_state(RandomStream& random) {
    const int parts = random.between(2, 13);
    BodyPlan plan = random_tree(random, parts, 0.3, 1.0, 0.0);
    for (PlannedPart& part : plan.parts) {
        if (random.uniform() < 0.7) part.stretch = PlannedStretch{-0.5, 0.5, 1.0, 1.5};
        if (random.uniform() < 0.3) part.motion = kRigidJoint;
    }
    if (!plan.parts.front().stretch)
        plan.parts.back().stretch = PlannedStretch{-0.5, 0.5, 1.0, 1.5};
    DeformingState state{*build_planar_model(plan, 1.0), {}, {}, {}};
    state.motion = rest_motion(state.model);
    for (int c = 0; c < coordinate_count(state.model); ++c) {
        state.motion.position[c] += 0.3 * random.gauss();
        state.motion.speed[c] = 3.0 * random.gauss();
    }
    compute_kinematics(state.model, state.motion, state.kinematics);
    clear_loads(state.model, state.loads);
    for (int i = 0; i < state.model.body_count; ++i) {
        const bool is_body = state.model.motion[i] != JointMotion::kStretch;
        state.loads.force_x[i] = is_body ? random.gauss() : 0.0;
        state.loads.force_y[i] = is_body ? random.gauss() : 0.0;
        state.loads.torque[i] = is_body ? random.gauss() : 0.0;
        const bool is_fixed = is_body && state.model.motion[i] == JointMotion::kFixed;
        state.loads.effort[i] = is_fixed ? 0.0 : random.gauss();
    }
    return state;
}

bool is_free(const PlanarModel& model, int c) {
    if (c >= model.body_count) return true;
    return model.parent[c] < 0 || model.motion[c] != JointMotion::kFixed;
}

// Solves M q'' = Q for all coordinates; those of rigid joints are 0.
Eigen::VectorXd dense_accelerations(const DeformingState& state, double damping_of_slots) {
    const PlanarModel& model = state.model;
    const int count = coordinate_count(model);
    Eigen::VectorXd speeds(count);
    for (int c = 0; c < count; ++c)
        speeds(c) = is_free(model, c) ? state.motion.speed[c] : 0.0;
    const Places now = places_of(model, state.motion, speeds);
    Eigen::MatrixXd mass = Eigen::MatrixXd::Zero(count, count);
    Eigen::VectorXd force = Eigen::VectorXd::Zero(count);
    std::vector<Places> columns;
    for (int c = 0; c < count; ++c)
        columns.push_back(places_of(model, state.motion, Eigen::VectorXd::Unit(count, c)));
    for (int i = 0; i < model.body_count; ++i) {
        if (model.motion[i] == JointMotion::kStretch) continue;
        const auto at = static_cast<std::size_t>(i);
        Eigen::MatrixXd jacobian(3, count);
        for (int c = 0; c < count; ++c) {
            const Places& column = columns[static_cast<std::size_t>(c)];
            jacobian.col(c) << column.center[at].x.rate, column.center[at].y.rate,
                column.angle[at].rate;
        }
        const int slot = model.stretch_slot[i];
        const double s = slot < 0 ? 0.0 : state.motion.position[slot];
        const double rate = slot < 0 ? 0.0 : state.motion.speed[slot];
        const double length = model.mass[i] * model.length_square[i] * std::exp(2.0 * s);
        const double width = model.mass[i] * model.width_square[i] * std::exp(-2.0 * s);
        const double inertia = slot < 0 ? model.inertia[i] : length + width;
        const double spin = now.angle[at].rate;
        const Eigen::Vector3d masses(model.mass[i], model.mass[i], inertia);
        const Eigen::Vector3d bias(now.center[at].x.bend, now.center[at].y.bend,
                                   now.angle[at].bend);
        Eigen::Vector3d load(state.loads.force_x[i], state.loads.force_y[i], state.loads.torque[i]);
        load(2) -= 2.0 * (length - width) * spin * rate;
        mass += jacobian.transpose() * masses.asDiagonal() * jacobian;
        force += jacobian.transpose() * (load - masses.cwiseProduct(bias));
        if (slot >= 0) {
            mass(slot, slot) += inertia + damping_of_slots;
            force(slot) +=
                state.loads.effort[slot] + (length - width) * (spin * spin - rate * rate);
        }
        if (model.parent[i] < 0) continue;
        force(i) += state.loads.effort[i];
        if (model.motion[i] != JointMotion::kTurn) continue;
        for (int c = 0; c < count; ++c)
            force(c) -= columns[static_cast<std::size_t>(c)]
                            .angle[static_cast<std::size_t>(model.parent[i])]
                            .rate *
                        state.loads.effort[i];
    }
    for (int c = 0; c < count; ++c) {
        if (is_free(model, c)) continue;
        mass.row(c).setZero();
        mass.col(c).setZero();
        mass(c, c) = 1.0;
        force(c) = 0.0;
    }
    return mass.ldlt().solve(force);
}

double relative_error(const PlanarModel& model, const BodyResponse& response,
                      const Eigen::VectorXd& dense) {
    double worst = 0.0;
    for (int c = 0; c < coordinate_count(model); ++c)
        worst = std::fmax(worst, std::fabs(response.coordinate[c] - dense(c)));
    return worst / dense.cwiseAbs().maxCoeff();
}

}  // namespace

TEST_CASE("the velocities of deforming trees are the rates of their places",
          "[dynamics][stretching]") {
    RandomStream random(stream_seed({231}));
    for (int round = 0; round < 100; ++round) {
        const DeformingState state = random_deforming_state(random);
        const PlanarModel& model = state.model;
        Eigen::VectorXd speeds(coordinate_count(model));
        for (int c = 0; c < coordinate_count(model); ++c)
            speeds(c) = state.motion.speed[c];
        const Places places = places_of(model, state.motion, speeds);
        for (int i = 0; i < model.body_count; ++i) {
            if (model.motion[i] == JointMotion::kStretch) continue;
            const Point& center = places.center[static_cast<std::size_t>(i)];
            CHECK(std::fabs(state.kinematics.x[i] - center.x.value) < 1e-12);
            CHECK(std::fabs(state.kinematics.y[i] - center.y.value) < 1e-12);
            CHECK(std::fabs(state.kinematics.velocity_x[i] - center.x.rate) < 1e-11);
            CHECK(std::fabs(state.kinematics.velocity_y[i] - center.y.rate) < 1e-11);
        }
    }
}

TEST_CASE("the elimination of stretches agrees with dense equations", "[dynamics][stretching]") {
    RandomStream random(stream_seed({232}));
    double worst = 0.0;
    for (int round = 0; round < 400; ++round) {
        const DeformingState state = random_deforming_state(random);
        Factors factors;
        BodyResponse response;
        solve_accelerations(state.model, state.kinematics, state.loads, factors, response);
        worst = std::fmax(worst,
                          relative_error(state.model, response, dense_accelerations(state, 0.0)));
    }
    CAPTURE(worst);
    CHECK(worst < 1e-12);
}

TEST_CASE("implicit motors damp a stretch like an added mass", "[dynamics][stretching]") {
    RandomStream random(stream_seed({233}));
    for (int round = 0; round < 100; ++round) {
        const DeformingState state = random_deforming_state(random);
        PerBody damping = {};
        for (int i = 0; i < state.model.body_count; ++i)
            damping[i] = state.model.motion[i] == JointMotion::kStretch ? 0.05 : 0.0;
        Factors factors;
        BodyResponse response;
        solve_damped_accelerations(state.model, state.kinematics, state.loads, damping, factors,
                                   response);
        CHECK(relative_error(state.model, response, dense_accelerations(state, 0.05)) < 1e-9);
    }
}

TEST_CASE("joints between deforming bodies lose their damping's effort", "[dynamics][stretching]") {
    RandomStream random(stream_seed({234}));
    for (int round = 0; round < 100; ++round) {
        DeformingState state = random_deforming_state(random);
        PerBody damping = {};
        for (int i = 0; i < state.model.body_count; ++i) {
            const bool has_motor =
                state.model.parent[i] >= 0 && state.model.motion[i] != JointMotion::kFixed;
            damping[i] = has_motor ? 0.03 * random.uniform() : 0.0;
        }
        Factors factors;
        BodyResponse implicit;
        solve_damped_accelerations(state.model, state.kinematics, state.loads, damping, factors,
                                   implicit);
        for (int i = 0; i < state.model.body_count; ++i) {
            if (damping[i] == 0.0) continue;
            double acceleration = implicit.coordinate[i];
            if (state.model.motion[i] == JointMotion::kTurn)
                acceleration -= implicit.spin[state.model.parent[i]];
            state.loads.effort[i] -= damping[i] * acceleration;
        }
        BodyResponse explicit_ones;
        solve_accelerations(state.model, state.kinematics, state.loads, factors, explicit_ones);
        for (int c = 0; c < coordinate_count(state.model); ++c)
            CHECK(implicit.coordinate[c] ==
                  Approx(explicit_ones.coordinate[c]).epsilon(1e-8).margin(1e-8));
    }
}

TEST_CASE("paired impulses of deforming trees are two single ones", "[dynamics][stretching]") {
    RandomStream random(stream_seed({235}));
    for (int round = 0; round < 50; ++round) {
        const DeformingState state = random_deforming_state(random);
        Factors factors;
        factorize(state.model, state.kinematics, factors);
        Loads loads[2] = {state.loads, state.loads};
        loads[1].torque[0] += 1.0;
        PerCoordinate jumps[2];
        solve_paired_impulses(state.model, state.kinematics, factors, loads, jumps);
        for (int which = 0; which < 2; ++which) {
            BodyResponse single;
            solve_impulse(state.model, state.kinematics, factors, loads[which], single);
            for (int c = 0; c < coordinate_count(state.model); ++c)
                CHECK(jumps[which][c] == single.coordinate[c]);
        }
    }
}
