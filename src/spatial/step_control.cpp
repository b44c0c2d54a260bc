#include "spatial/step_control.h"

#include "core/assert.h"
#include "dynamics/step_policy.h"
#include "world/environment.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace cambrian::spatial {
namespace {

constexpr double kMaxStep = 1.0 / 60;  // s

bool is_sound(const Model& model, const State& state) {
    const Motion& motion = state.motion;
    const auto fits = [](double number, double most) { return std::fabs(number) <= most; };
    const auto fit = [&fits](const Vec3& v, double most) {
        return fits(v.x(), most) && fits(v.y(), most) && fits(v.z(), most);
    };
    for (int d = 0; d < model.degree_count; ++d) {
        if (!fits(motion.position[d], step_policy::kMaxDistance) ||
            !fits(motion.speed[d], step_policy::kMaxSpeed))
            return false;
    }
    return fit(coordinate_vector(motion.position + model.place()), step_policy::kMaxDistance) &&
           fit(coordinate_vector(motion.speed + model.place()), step_policy::kMaxSpeed) &&
           fit(state.evaluation->kinematics.spin[0], step_policy::kMaxSpeed) &&
           std::isfinite(motion.root.w() + motion.root.x() + motion.root.y() + motion.root.z());
}

Vec3 part_velocity(const Model& model, const State& state, int index) {
    const Part& part = model.parts[index];
    const Kinematics& k = state.evaluation->kinematics;
    return k.velocity[part.body] + cross(k.spin[part.body], k.turn[part.body] * part.place) +
           coordinate_vector(state.motion.speed + model.place());
}

void note_speeds(const Model& model, State& state) {
    SceneAudit& audit = state.audit;
    for (int p = 0; p < model.part_count; ++p) {
        const Vec3 velocity = part_velocity(model, state, p);
        audit.max_part_speed = std::max(audit.max_part_speed, std::sqrt(dot(velocity, velocity)));
    }
    for (int b = 0; b < model.body_count; ++b) {
        const Vec3& spin = state.evaluation->kinematics.spin[b];
        audit.max_part_spin = std::max(audit.max_part_spin, std::sqrt(dot(spin, spin)));
    }
}

void update_audit(const Model& model, const Medium& medium, State& state) {
    SceneAudit& audit = state.audit;
    const double* work = state.motion.work;
    audit.motor_work = work[kMotorWork];
    audit.gross_motor_work = work[kGrossMotorWork];
    audit.drag_work = work[kDragWork];
    const double explained = work[kMotorWork] + work[kDragWork] + work[kPullWork] +
                             audit.limit_work + audit.impulse_work;
    audit.energy_residual =
        mechanical_energy(model, medium, state.motion, state.evaluation->kinematics) -
        state.energy_reference - explained;
    const double gravity = std::sqrt(dot(medium.gravity, medium.gravity));
    audit.energy_scale = audit.gross_motor_work + model.mass * gravity * step_policy::kScaleHeight;
}

}  // namespace

void start_audit(const Model& model, const Medium& medium, State& state) {
    for (double& work : state.motion.work)
        work = 0.0;
    state.audit = {};
    state.energy_reference =
        mechanical_energy(model, medium, state.motion, state.evaluation->kinematics);
    update_audit(model, medium, state);
}

StepControl::StepControl(const Integrator& integrator, const SceneSettings& settings)
    : integrator_(&integrator),
      tolerance_(settings.tolerance),
      contact_step_(settings.contact_step),
      underflow_step_(std::min(
          step_policy::kUnderflowShare * contact_step_,
          step_policy::kUnderflowStep *
              inverse_root(step_policy::kUsualTolerance / tolerance_, MidpointStep::kErrorOrder))),
      max_evaluations_(settings.max_evaluations) {}

void StepControl::advance(const Model& model, Forcing& forcing, double duration, State& state) {
    forcing.drive = state.drive;
    state.evaluation_debt = std::max(0.0, state.evaluation_debt - max_evaluations_ * duration);
    Tick tick{model, forcing, state, duration};
    const Motion start = state.motion;
    const SceneAudit audit_before = state.audit;
    make_current(tick);
    Vec3 velocity[kMostParts];
    for (int p = 0; p < model.part_count; ++p) {
        if (model.measured[p]) velocity[p] = part_velocity(model, state, p);
    }
    state.status = SceneStatus::kRunning;
    while (tick.length - tick.time > step_policy::kSliver && state.status == SceneStatus::kRunning)
        state.status = step(tick);
    tick.time = tick.length;
    if (state.status == SceneStatus::kRunning) {
        make_current(tick);
        if (!is_sound(model, state)) state.status = SceneStatus::kInvalid;
    }
    if (state.status != SceneStatus::kRunning) {
        // Back to the tick's start, but for the counters.
        const SceneAudit spent = std::exchange(state.audit, audit_before);
        state.motion = start;
        state.is_current = false;
        tick.time = 0.0;
        make_current(tick);
        step_policy::keep_counts(spent, state.audit);
        update_audit(model, forcing.medium, state);
        return;
    }
    state.time += duration;
    std::copy(state.drive.end, state.drive.end + model.degree_count, state.drive.start);
    for (int p = 0; p < model.part_count; ++p) {
        if (model.measured[p])
            state.specific_force[p].value =
                (part_velocity(model, state, p) - velocity[p]) / duration - forcing.medium.gravity;
    }
    note_speeds(model, state);
    update_audit(model, forcing.medium, state);
}

// Makes one accepted step or one impact.
SceneStatus StepControl::step(Tick& tick) {
    make_current(tick);
    bool has_rows = false;
    double h = choose_length(tick, has_rows);
    switch (attempt(tick, has_rows, h)) {
        case Attempt::kDiverged:
            return SceneStatus::kInvalid;
        case Attempt::kOverBudget:
            return SceneStatus::kOverBudget;
        case Attempt::kUnderflow:
            return SceneStatus::kRunning;
        case Attempt::kAccepted:
            break;
    }
    tick.underflows = 0;
    accept(tick, has_rows, h);
    return SceneStatus::kRunning;
}

void StepControl::make_current(Tick& tick) {
    State& state = tick.state;
    if (state.is_current) return;
    const MotionSystem system{tick.model, tick.forcing, tick.length};
    system.evaluate(state.motion, tick.time, *state.evaluation, state.rate);
    count_evaluations(tick, 1);
    state.is_current = true;
}

void StepControl::count_evaluations(Tick& tick, int evaluations) {
    tick.state.audit.evaluations += static_cast<std::uint64_t>(evaluations);
    tick.state.evaluation_debt += evaluations;
}

// Divides the rest of the tick evenly, so that no tiny step remains.
double StepControl::choose_length(Tick& tick, bool& has_rows) {
    double h = std::min(tick.state.proposed_step, kMaxStep);
    has_rows = limits_.select(tick.model, tick.state.motion, h);
    if (has_rows) h = std::min(h, contact_step_);
    if (tick.underflows >= step_policy::kMaxUnderflows) {
        has_rows = false;
        h = std::min(h, step_policy::kNoRowsShare * contact_step_);
    }
    const double rest = tick.length - tick.time;
    const double steps = std::ceil(rest / h * (has_rows ? 0.9 : 1.0 - 1e-9));
    return rest / std::max(1.0, steps);
}

StepControl::Attempt StepControl::attempt(Tick& tick, bool has_rows, double& h) {
    State& state = tick.state;
    const int order = has_rows ? MidpointStep::kErrorOrder : integrator_->error_order;
    if (!has_rows) limits_.clear();
    for (;;) {
        try_step(tick, has_rows, h);
        count_evaluations(tick, result_.evaluations);
        if (state.evaluation_debt > step_policy::kBudgetTime * max_evaluations_)
            return Attempt::kOverBudget;
        if (!(result_.error <= 1.0)) {
            ++state.audit.rejections;
            h *= std::min(step_policy::step_factor(result_.error, order), 0.9);
            state.proposed_step = h;
            if (h < step_policy::kMinStep)
                return std::isfinite(result_.error) ? Attempt::kOverBudget : Attempt::kDiverged;
            if (!has_rows || h >= underflow_step_) continue;
            ++tick.underflows;
            apply_impact(tick);
            state.proposed_step = contact_step_;
            return Attempt::kUnderflow;
        }
        if (must_halve(tick, h)) {
            ++state.audit.rejections;
            h *= 0.5;
            continue;
        }
        propose_length(h, order, state.proposed_step);
        return Attempt::kAccepted;
    }
}

void StepControl::try_step(Tick& tick, bool has_rows, double h) {
    State& state = tick.state;
    const MotionSystem system{tick.model, tick.forcing, tick.length};
    const StepRequest request{state.motion, state.rate, tick.time, h, tolerance_};
    if (!has_rows) {
        integrator_->attempt(system, request, *end_, result_);
        return;
    }
    const MotionRate& prediction = state.has_last_rate ? state.last_rate : state.rate;
    if (!midpoint_.attempt(system, request, prediction, limits_, *end_, result_))
        ++state.audit.fallbacks;
}

// Stops all joints that close at a stop, without restitution.
void StepControl::apply_impact(Tick& tick) {
    State& state = tick.state;
    if (limits_.select_touched(tick.model, state.motion)) {
        if (!limits_.solve_impact(tick.model, *state.evaluation)) ++state.audit.fallbacks;
        double efforts[kMostJointDegrees] = {};
        limits_.add_efforts(1.0, efforts);
        Response jump;
        respond(tick.model, state.evaluation->kinematics, state.evaluation->factors, efforts, jump);
        double work = 0.0;
        for (int i = 0; i < limits_.count(); ++i)
            work += limits_.impulse(i) * (limits_.row(i).rate + 0.5 * limits_.effect(i));
        for (int d = 0; d < tick.model.degree_count; ++d)
            state.motion.speed[d] += jump.joint[d];
        state.audit.impulse_work += work;
        state.audit.positive_work += std::max(0.0, work);
    }
    ++state.audit.events;
    state.is_current = false;
    state.has_last_rate = false;
}

// Positive work of stops shows that the step is too long for constant forces. So does a joint that
// overruns a stop that was not selected. Energy that no work explains shows that it is too long for
// its motion.
bool StepControl::must_halve(const Tick& tick, double h) {
    limit_work_ = 0.0;
    positive_work_ = 0.0;
    for (int i = 0; i < limits_.count(); ++i) {
        const LimitRow& row = limits_.row(i);
        const double way =
            result_.end.position[row.degree] - tick.state.motion.position[row.degree];
        const double work = limits_.impulse(i) / h * row.sign * way;
        limit_work_ += work;
        positive_work_ += std::max(0.0, work);
    }
    if (h <= step_policy::kHalvingStep) return false;
    const double weight = tick.model.mass * kEarthGravity;
    if (positive_work_ > step_policy::kStepWorkAllowance * weight) return true;
    if (result_.error > step_policy::kGainlessError &&
        unexplained_gain(tick) > step_policy::kStepGainAllowance * weight)
        return true;
    const double overrun = limit_overrun(tick.model, result_.end);
    return overrun > step_policy::kMaxOverrun &&
           overrun > limit_overrun(tick.model, tick.state.motion) + step_policy::kOverrunGrowth;
}

// Returns the energy that the attempted step adds without work, in J.
double StepControl::unexplained_gain(const Tick& tick) const {
    const State& state = tick.state;
    const Medium& medium = tick.forcing.medium;
    double gain = mechanical_energy(tick.model, medium, result_.end, end_->kinematics) -
                  mechanical_energy(tick.model, medium, state.motion, state.evaluation->kinematics);
    for (const Work w : {kMotorWork, kDragWork, kPullWork})
        gain -= result_.end.work[w] - state.motion.work[w];
    return gain - limit_work_;
}

// Proposes the next step's length after an accepted step, which may have been truncated.
void StepControl::propose_length(double h, int order, double& proposed) const {
    const bool truncated = h < proposed;
    if (result_.error <= kCalmError && (truncated ? proposed : h) >= kMaxStep) {
        proposed = kMaxStep;
        return;
    }
    const double grown = h * step_policy::step_factor(result_.error, order);
    proposed = std::min(truncated ? std::max(proposed, grown) : grown, kMaxStep);
}

void StepControl::accept(Tick& tick, bool has_rows, double h) {
    State& state = tick.state;
    state.audit.limit_work += limit_work_;
    state.audit.positive_work += positive_work_;
    state.audit.max_limit_overrun =
        std::max(state.audit.max_limit_overrun, limit_overrun(tick.model, result_.end));
    ++state.audit.steps;
    state.motion = result_.end;
    restart_chart(tick.model, state.motion);
    state.evaluation.swap(end_);
    state.rate = result_.end_rate;
    // The chart starts again, and its rate is the root's spin.
    set_coordinate_vector(state.rate.position + tick.model.attitude(),
                          state.evaluation->kinematics.spin[0]);
    state.has_last_rate = has_rows;
    if (has_rows) state.last_rate = midpoint_.mean_rate();
    tick.time += h;
}

}  // namespace cambrian::spatial
