#include "dynamics/articulated/loop_closure.h"

#include "core/assert.h"
#include "dynamics/model/loop_joints.h"

namespace cambrian {
namespace {

constexpr double kRankThreshold = 1e-10;  // of the largest pivot; smaller ones are redundant rows

void add_impulse(int body, const Vec2& arm, const Vec2& impulse, Loads& loads) {
    loads.force_x[body] += impulse.x();
    loads.force_y[body] += impulse.y();
    loads.torque[body] += perp(arm).dot(impulse);
}

}  // namespace

LoopClosure::LoopClosure(const PlanarModel& model, const Kinematics& kinematics,
                         const Factors& factors)
    : model_(model), kinematics_(kinematics) {
    for (const LoopJoint& joint : model.loop_joints) {
        CAMBRIAN_TICK_ASSERT(joint.body_a != joint.body_b, "a loop-closure joint joins two bodies");
        const LoopArms arms = loop_arms(kinematics, joint);
        for (const Vec2& direction : {Vec2(1.0, 0.0), Vec2(0.0, 1.0)}) {
            Loads loads;
            clear_loads(model, loads);
            add_impulse(joint.body_a, arms.a, direction, loads);
            add_impulse(joint.body_b, arms.b, -direction, loads);
            solve_impulse(model, kinematics, factors, loads, units_.emplace_back());
        }
    }
    CAMBRIAN_TICK_ASSERT(units_.size() == 2 * model.loop_joints.size(), "two rows for each joint");
    const auto rows = static_cast<Eigen::Index>(units_.size());
    Eigen::MatrixXd matrix(rows, rows);
    for (Eigen::Index row = 0; row < rows; ++row) {
        const BodyResponse& unit = units_[static_cast<std::size_t>(row)];
        matrix.col(row) = rates_of(unit.x, unit.y, unit.spin);
    }
    decomposition_.setThreshold(kRankThreshold);
    decomposition_.compute(matrix);
}

LoopClosure::Rates LoopClosure::rates_of(const PerBody& x, const PerBody& y,
                                         const PerBody& spin) const {
    Rates rates(static_cast<Eigen::Index>(units_.size()));
    Eigen::Index row = 0;
    for (const LoopJoint& joint : model_.loop_joints) {
        const LoopArms arms = loop_arms(kinematics_, joint);
        const int a = joint.body_a;
        const int b = joint.body_b;
        rates.segment<2>(row) =
            Vec2(x[a], y[a]) + spin[a] * perp(arms.a) - Vec2(x[b], y[b]) - spin[b] * perp(arms.b);
        row += 2;
    }
    return rates;
}

void LoopClosure::add_response(const Rates& rates, BodyResponse& response) const {
    const Rates impulse = impulses(rates);
    for (std::size_t row = 0; row < units_.size(); ++row) {
        const BodyResponse& unit = units_[row];
        const double size = impulse(static_cast<Eigen::Index>(row));
        for (int i = 0; i < model_.body_count; ++i) {
            response.x[i] += size * unit.x[i];
            response.y[i] += size * unit.y[i];
            response.spin[i] += size * unit.spin[i];
        }
        for (int c = 0; c < coordinate_count(model_); ++c)
            response.coordinate[c] += size * unit.coordinate[c];
    }
}

void LoopClosure::close_accelerations(BodyResponse& accelerations) const {
    Rates rates = rates_of(accelerations.x, accelerations.y, accelerations.spin);
    Eigen::Index row = 0;
    for (const LoopJoint& joint : model_.loop_joints) {
        rates.segment<2>(row) += loop_bias(kinematics_, joint, loop_arms(kinematics_, joint));
        row += 2;
    }
    add_response(-rates, accelerations);
}

void LoopClosure::close_jumps(BodyResponse& jumps) const {
    add_response(-rates_of(jumps.x, jumps.y, jumps.spin), jumps);
}

void LoopClosure::close_drift(Motion& motion) const {
    Rates gaps(static_cast<Eigen::Index>(units_.size()));
    Eigen::Index row = 0;
    for (const LoopJoint& joint : model_.loop_joints) {
        gaps.segment<2>(row) = loop_gap(kinematics_, joint, loop_arms(kinematics_, joint));
        row += 2;
    }
    BodyResponse moved = {};
    add_response(-gaps, moved);
    BodyResponse jump = {};
    add_response(-rates_of(kinematics_.velocity_x, kinematics_.velocity_y, kinematics_.spin), jump);
    for (int c = 0; c < coordinate_count(model_); ++c) {
        motion.position[c] += moved.coordinate[c];
        motion.speed[c] += jump.coordinate[c];
    }
}

void close_accelerations(const PlanarModel& model, const Kinematics& kinematics,
                         const Factors& factors, BodyResponse& accelerations) {
    LoopClosure(model, kinematics, factors).close_accelerations(accelerations);
}

void solve_closed_impulse(const PlanarModel& model, const Kinematics& kinematics,
                          const Factors& factors, const Loads& impulses, BodyResponse& response) {
    solve_impulse(model, kinematics, factors, impulses, response);
    if (!model.loop_joints.empty()) LoopClosure(model, kinematics, factors).close_jumps(response);
}

}  // namespace cambrian
