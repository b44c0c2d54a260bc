#include "spatial/step_control.h"

#include "core/assert.h"
#include "dynamics/step_policy.h"
#include "spatial/audit.h"
#include "world/environment.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace cambrian::spatial {
namespace {

constexpr double kMaxStep = 1.0 / 60;         // s
constexpr double kRestStep = 1.0 / 120;       // s; longest step of what nearly rests
constexpr double kRestRate = 0.2;             // m/s and rad/s; what is slower nearly rests
constexpr double kMaxSwingOverrun = 5e-3;     // rad; of a ball's cone, whose direction turns
constexpr double kSwingOverrunGrowth = 2e-3;  // rad; in one step

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

// Touches the face of a part whose normal is nearest to a direction in the world.
void touch_toward(const Model& model, const Kinematics& k, int index, const Vec3& direction,
                  State& state) {
    const Part& part = model.parts[index];
    const Vec3 along = (k.turn[part.body] * part.turn).back(direction);
    int nearest = 0;
    for (int a = 1; a < 3; ++a) {
        if (std::fabs(along[a]) > std::fabs(along[nearest])) nearest = a;
    }
    constexpr Face kFaces[3][2] = {
        {Face::kProximal, Face::kDistal}, {Face::kRight, Face::kLeft}, {Face::kBack, Face::kFront}};
    const Face face = kFaces[nearest][along[nearest] > 0.0 ? 1 : 0];
    state.touched[index] |= static_cast<std::uint8_t>(1U << static_cast<unsigned>(face));
}

// Touches the faces of both parts, and adds the normal impulse to their loads.
void note_touch(const Model& model, const Kinematics& k, const Contact& contact, double impulse,
                State& state) {
    const Vec3 normal = surface_of(k, contact).axis[0];
    touch_toward(model, k, contact.part, -normal, state);
    state.load[contact.part] += impulse;
    if (contact.is_on_ground()) return;
    touch_toward(model, k, contact.other_part, normal, state);
    state.load[contact.other_part] += impulse;
}

}  // namespace

StepControl::StepControl(const Model& model, const Integrator& integrator,
                         const SceneSettings& settings)
    : integrator_(&integrator), limits_(settings, MidpointStep::kErrorOrder), rows_(model) {}

void StepControl::advance(const Model& model, Forcing& forcing, double duration, State& state) {
    forcing.drive = state.drive;
    state.evaluation_debt =
        std::max(0.0, state.evaluation_debt - limits_.max_evaluations * duration);
    Tick tick{{duration}, model, forcing, state};
    const Motion start = state.motion;
    const SceneAudit audit_before = state.audit;
    std::fill_n(state.touched, kMostParts, std::uint8_t{0});
    std::fill_n(state.load, kMostParts, 0.0);
    state.impact_count = 0;
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
        if (!model.measured[p]) continue;
        state.specific_force[p].value =
            (part_velocity(model, state, p) - velocity[p]) / duration - forcing.medium.gravity;
        state.load[p] /= duration;
    }
    note_speeds(model, state);
    update_audit(model, forcing.medium, state);
}

// Makes one accepted step or one impact.
SceneStatus StepControl::step(Tick& tick) {
    State& state = tick.state;
    make_current(tick);
    if (!tick.detected) detect(tick, state.motion, state.evaluation->kinematics);
    const bool can_bounce = tick.impacts < step_policy::kMaxImpacts;
    if (can_bounce && has_impact()) {
        apply_impact(tick, tick.forcing.ground.restitution);
        return SceneStatus::kRunning;
    }
    bool has_rows = false;
    double h = choose_length(tick, has_rows);
    const double depth = near_.depth();
    if (tick.time == 0.0) tick.start_depth = depth;
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
    detect(tick, result_.end, end_->kinematics);
    tick.detected = true;
    if (can_bounce && has_new_impact(near_, rows_)) {
        accept_part(tick, has_rows, h);
    } else if (step_policy::is_too_deep(tick, depth, near_.depth(), h)) {
        ++state.audit.rejections;
        state.proposed_step = 0.5 * h;
        tick.detected = false;
        return SceneStatus::kRunning;
    } else {
        accept(tick, has_rows, h);
    }
    tick.underflows = 0;
    return SceneStatus::kRunning;
}

void StepControl::detect(const Tick& tick, const Motion& motion, const Kinematics& kinematics) {
    detect_contacts(tick.model, tick.forcing.ground.is_there, motion, kinematics, near_);
}

bool StepControl::has_impact() const {
    for (int c = 0; c < near_.count; ++c) {
        const Contact& contact = near_.items[c];
        if (contact.gap < kContactBand && contact.closing_speed() > kRestingSpeed) return true;
    }
    return false;
}

// Whether a body on the ground has nearly come to rest. At 1/60 s some never do.
bool StepControl::rests(const Tick& tick) const {
    if (rows_.contact_count() == 0) return false;
    const State& state = tick.state;
    const auto slow = [](const Vec3& rate) { return dot(rate, rate) < kRestRate * kRestRate; };
    for (int d = 0; d < tick.model.degree_count; ++d) {
        if (std::fabs(state.motion.speed[d]) >= kRestRate) return false;
    }
    return slow(state.evaluation->kinematics.spin[0]) &&
           slow(coordinate_vector(state.motion.speed + tick.model.place()));
}

void StepControl::make_current(Tick& tick) {
    State& state = tick.state;
    if (state.is_current) return;
    const MotionSystem system{tick.model, tick.forcing, tick.length};
    system.evaluate(state.motion, tick.time, *state.evaluation, state.rate);
    step_policy::count_evaluations(state, 1);
    state.is_current = true;
}

double StepControl::choose_length(Tick& tick, bool& has_rows) {
    double h = std::min(tick.state.proposed_step, kMaxStep);
    const State& state = tick.state;
    has_rows =
        rows_.select({tick.model, state.motion, *state.evaluation, tick.forcing.medium.gravity},
                     near_, state.held, h);
    if (has_rows)
        h = std::min(
            h, rests(tick) ? std::min(limits_.contact_step, kRestStep) : limits_.contact_step);
    return step_policy::even_length(tick, limits_, h, has_rows);
}

StepControl::Attempt StepControl::attempt(Tick& tick, bool has_rows, double& h) {
    if (!has_rows) rows_.clear();
    const int order = has_rows ? MidpointStep::kErrorOrder : integrator_->error_order;
    const Attempt outcome = step_policy::attempt(
        limits_, {order, kMaxStep, has_rows}, tick.state, result_, h,
        [&](double length) { try_step(tick, has_rows, length); },
        [&](double length) { return must_halve(tick, length); });
    if (outcome != Attempt::kUnderflow) return outcome;
    ++tick.underflows;
    apply_impact(tick, 0.0);
    tick.state.proposed_step = limits_.contact_step;
    return outcome;
}

void StepControl::try_step(Tick& tick, bool has_rows, double h) {
    State& state = tick.state;
    const MotionSystem system{tick.model, tick.forcing, tick.length};
    const StepRequest request{state.motion, state.rate, tick.time, h, limits_.tolerance};
    if (!has_rows) {
        integrator_->attempt(system, request, *end_, result_);
        return;
    }
    const MotionRate& prediction = state.has_last_rate ? state.last_rate : state.rate;
    if (!midpoint_.attempt(system, request, prediction, rows_, *end_, result_))
        ++state.audit.fallbacks;
}

// Solves the impact of everything that touches.
void StepControl::apply_impact(Tick& tick, double restitution) {
    State& state = tick.state;
    const Model& model = tick.model;
    if (rows_.select_touched({model, state.motion, *state.evaluation, tick.forcing.medium.gravity},
                             near_)) {
        const Rows::Impact impact =
            rows_.solve_impact(model, tick.forcing.ground.friction, restitution, *state.evaluation);
        Push push;
        rows_.add_push(1.0, push);
        Response response;
        respond(model, state.evaluation->kinematics, state.evaluation->factors, push, response);
        add_push(model, push, response, state.motion.speed);
        state.audit.impulse_work += impact.work;
        state.audit.positive_work += std::max(0.0, impact.work);
        state.audit.fallbacks += impact.settled ? 0U : 1U;
        note_impacts(tick);
    }
    ++state.audit.events;
    ++tick.impacts;
    tick.detected = false;
    state.is_current = false;
    state.has_last_rate = false;
}

void StepControl::note_impacts(Tick& tick) {
    State& state = tick.state;
    const Kinematics& k = state.evaluation->kinematics;
    const Vec3 center = coordinate_vector(state.motion.position + tick.model.place());
    for (int c = 0; c < rows_.contact_count(); ++c) {
        const Contact& contact = rows_.contact(c);
        const double impulse = rows_.normal_impulse(c);
        note_touch(tick.model, k, contact, impulse, state);
        NotedImpact* const end = state.impacts + state.impact_count;
        NotedImpact* noted = std::find_if(state.impacts, end, [&](const NotedImpact& each) {
            return std::minmax(each.body, each.other_body) ==
                   std::minmax(contact.body, contact.other_body);
        });
        if (noted == end) {
            if (state.impact_count == static_cast<int>(kMostImpacts)) continue;
            ++state.impact_count;
            *noted = {.body = contact.body,
                      .other_body = contact.other_body,
                      .part = contact.part,
                      .other_part = contact.other_part};
        }
        noted->impulse += impulse;
        noted->lost += rows_.impact_loss(c);
        noted->point += impulse * (center + place_of(k, contact));
    }
}

// A joint that overruns a stop that was not selected shows that the step is too long, too.
bool StepControl::must_halve(const Tick& tick, double h) {
    work_ = rows_.work(tick.model, tick.state.motion, tick.state.evaluation->kinematics,
                       result_.end, end_->kinematics, h);
    const double overrun = limit_overrun(tick.model, result_.end);
    const bool leaves_stop =
        overrun > step_policy::kMaxOverrun &&
        overrun > limit_overrun(tick.model, tick.state.motion) + step_policy::kOverrunGrowth;
    // Without rows no stop holds, so that even a short step may leave one far behind.
    if (h <= step_policy::kHalvingStep)
        return tick.underflows >= step_policy::kMaxUnderflows && leaves_stop;
    const double weight = tick.model.mass * kEarthGravity;
    if (step_policy::gives_energy(work_.positive, result_.error, weight,
                                  [&] { return unexplained_gain(tick); }))
        return true;
    const double swing = swing_overrun(tick.model, result_.end);
    return leaves_stop ||
           (swing > kMaxSwingOverrun &&
            swing > swing_overrun(tick.model, tick.state.motion) + kSwingOverrunGrowth);
}

// Returns the energy that the attempted step adds without work, in J.
double StepControl::unexplained_gain(const Tick& tick) const {
    const State& state = tick.state;
    const Medium& medium = tick.forcing.medium;
    double gain = mechanical_energy(tick.model, medium, result_.end, end_->kinematics) -
                  mechanical_energy(tick.model, medium, state.motion, state.evaluation->kinematics);
    for (const Work w : {kMotorWork, kDragWork, kPullWork})
        gain -= result_.end.work[w] - state.motion.work[w];
    return gain - work_.contact - work_.limit;
}

void StepControl::accept(Tick& tick, bool has_rows, double h) {
    State& state = tick.state;
    add_to_audit(tick, 1.0);
    rows_.store(h, state.held);
    state.motion = result_.end;
    restart_chart(tick.model, state.motion);
    state.evaluation.swap(end_);
    state.rate = result_.end_rate;
    restart_chart_rates(tick.model, state.motion, state.evaluation->kinematics.spin[0], state.rate);
    state.has_last_rate = has_rows;
    if (has_rows) state.last_rate = midpoint_.mean_rate();
    tick.time += h;
}

// Accepts the step up to its first impact.
void StepControl::accept_part(Tick& tick, bool has_rows, double h) {
    State& state = tick.state;
    const StepRequest request{state.motion, state.rate, tick.time, h, limits_.tolerance};
    if (has_rows) {
        midpoint_.rates_at_ends(tick.model, request, result_, first_, last_);
    } else {
        first_ = state.rate;
        last_ = result_.end_rate;
    }
    const StepEnds ends{state.motion, first_, result_.end, last_, h, tick.forcing.ground.is_there};
    const double share = find_impact(tick.model, ends, rows_, near_, part_, end_->kinematics);
    work_ = rows_.work(tick.model, state.motion, state.evaluation->kinematics, part_,
                       end_->kinematics, h);
    result_.end = part_;
    add_to_audit(tick, share);
    rows_.store(h, state.held);
    state.motion = part_;
    restart_chart(tick.model, state.motion);
    state.is_current = false;
    state.has_last_rate = false;
    tick.time += share * h;
}

// Adds the accepted share of a step.
void StepControl::add_to_audit(Tick& tick, double share) {
    State& state = tick.state;
    SceneAudit& audit = state.audit;
    audit.contact_work += work_.contact;
    audit.limit_work += work_.limit;
    audit.positive_work += work_.positive;
    audit.max_penetration = std::max(audit.max_penetration, near_.depth());
    audit.max_limit_overrun =
        std::max(audit.max_limit_overrun, limit_overrun(tick.model, result_.end));
    ++audit.steps;
    for (int c = 0; c < rows_.contact_count(); ++c) {
        const Contact& contact = rows_.contact(c);
        const double impulse = rows_.normal_impulse(c);
        if (contact.gap >= kContactBand && !(impulse > 0.0)) continue;
        note_touch(tick.model, state.evaluation->kinematics, contact, share * impulse, state);
    }
}

}  // namespace cambrian::spatial
