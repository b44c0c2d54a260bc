#include "planar/stepping/step_control.h"

#include "dynamics/step_policy.h"
#include "math/elementary.h"
#include "planar/constraints/invariants.h"
#include "planar/evaluation/cache_numbers.h"
#include "planar/stepping/audit.h"
#include "planar/stepping/time_of_impact.h"
#include "planar/stepping/tree_spins.h"
#include "world/environment.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <type_traits>
#include <utility>

namespace cambrian {
namespace {

constexpr int kMostStops = 64;  // per tick; fewer impacts stop boxes that would pass each other

ComputedParts parts_computed_of(const PlanarModel& model) {
    return {.counts = counts_of(model),
            .dense_blocks = model.dense.blocks,
            .has_slides = model.has_slides,
            .has_stretches = model.stretch_count > 0};
}

template <class Numbers>
void set_to_zero(Numbers& numbers) {
    static_assert(std::is_trivially_copyable_v<Numbers>);
    std::memset(static_cast<void*>(&numbers), 0, sizeof numbers);
}

}  // namespace

StepControl::StepControl(const IntegratorKind& integrator, const SceneSettings& settings)
    : integrator_(&integrator), limits_(settings, MidpointStep::kErrorOrder) {}

// What a model does not compute must be 0, as in the memory of a scene of its own. Where the same
// is computed of more or fewer bodies, most of it is 0 already.
void StepControl::change_model(const PlanarModel& model) {
    contacts_.forget_model();
    const ComputedParts next = parts_computed_of(model);
    if (next == computed_) return;
    if (next.is_alike(computed_)) {
        ChangedCounts counts{next.counts, lanes_of(computed_.counts)};
        if (next.dense_blocks != computed_.dense_blocks) counts.now.dense_matrix = 0;
        clear_beyond(counts);
    } else {
        clear_all();
    }
    computed_ = next;
}

void StepControl::clear_all() {
    set_to_zero(midpoint_);
    set_to_zero(spare_.get());
    set_to_zero(held_rate_);
    set_to_zero(result_);
}

void StepControl::clear_beyond(const ChangedCounts& counts) {
    Clearing clearing;
    midpoint_.clear_beyond(counts);
    visit_cache(spare_.get(), counts, clearing);
    visit_rate(held_rate_, counts, clearing);
    visit_motion(result_.end, counts, clearing);
    visit_rate(result_.end_rate, counts, clearing);
}

void StepControl::advance(const PlanarModel& model, const ContactLaw& law, Forcing& forcing,
                          double duration, SimulationState& state) {
    CAMBRIAN_TICK_ASSERT(duration > 0.0, "a tick takes time");
    CAMBRIAN_TICK_ASSERT(state.status == SceneStatus::kRunning, "only sound scenes go on");
    CAMBRIAN_TICK_ASSERT(is_finite(model, state.motion), "a tick starts from a finite motion");
    CAMBRIAN_TICK_ASSERT(are_parents_before_children(model), "a parent comes before its children");
    for (std::uint8_t& faces : state.touched)
        faces = 0;
    state.impact_count = 0;
    if (model.measured_parts != 0) begin_forces(model, state.forces);
    state.evaluation_debt =
        std::max(0.0, state.evaluation_debt - limits_.max_evaluations * duration);
    Tick tick{{duration}, model, law, forcing, state};
    tick.detected = state.cache_is_current && state.detection == detection_;
    Motion start;
    copy_motion(model, state.motion, start);
    const SceneAudit audit_before = state.audit;
    while (tick.length - tick.time > step_policy::kSliver) {
        state.status = step(tick);
        if (state.status != SceneStatus::kRunning) return roll_back(tick, start, audit_before);
    }
    tick.time = tick.length;
    make_current(tick);
    state.status = status_of(tick);
    if (state.status != SceneStatus::kRunning) return roll_back(tick, start, audit_before);
    state.detection = tick.detected ? ++detection_ : 0;
    state.time += duration;
    remember_contacts(tick);
    if (model.measured_parts != 0)
        end_forces(model, forcing.medium, state.cache().kinematics, duration, state.forces);
    note_speeds(model, state.cache().kinematics, state.audit);
    if (std::floor(state.time) != std::floor(state.time - duration)) check_spins(model, state);
    update_audit(model, forcing.medium, state);
}

// Restores the state of the tick's start except for the counters, after a step that failed.
void StepControl::roll_back(Tick& tick, const Motion& start, const SceneAudit& audit_before) {
    SimulationState& state = tick.state;
    const SceneAudit spent = std::exchange(state.audit, audit_before);
    CAMBRIAN_TICK_ASSERT(is_finite(tick.model, start), "a tick can be rolled back");
    copy_motion(tick.model, start, state.motion);
    state.cache_is_current = false;
    state.known_spins = 0;
    tick.time = 0.0;
    make_current(tick);
    step_policy::keep_counts(spent, state.audit);
    update_audit(tick.model, tick.forcing.medium, state);
}

// Makes one accepted step or one impact.
SceneStatus StepControl::step(Tick& tick) {
    CAMBRIAN_TICK_ASSERT(tick.time < tick.length, "something is left of the tick");
    make_current(tick);
    if (!tick.detected) contacts_.detect(tick.model, tick.law, tick.state.cache().kinematics);
    const bool can_bounce = tick.impacts < step_policy::kMaxImpacts;
    if ((can_bounce || tick.must_stop) && contacts_.has_impact()) {
        tick.must_stop = false;
        apply_impact(tick, can_bounce ? tick.law.restitution : 0.0);
        return SceneStatus::kRunning;
    }
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
    const bool is_last = tick.time + h > tick.length - step_policy::kSliver;
    const BodySet free = free_trees(tick.model, tick.forcing, contacts_.held());
    if (const auto energy = restore_spins(tick.model, tick.forcing.medium, free, is_last,
                                          tick.state, result_.end, spare_.get().kinematics))
        end_energy_ = energy;
    Kinematics& end = spare_.get().kinematics;
    const double depth = contacts_.near().depth();
    if (tick.time == 0.0) tick.start_depth = depth;
    contacts_.detect(tick.model, tick.law, end);
    tick.detected = true;
    const StepEnds ends{tick.state.motion, *start_rate_, result_.end, *end_rate_, h};
    const std::optional<double> until = look_for_crossing(tick, ends, depth);
    tick.must_stop = until && *until < 1.0;
    const bool stops = tick.must_stop || (until && can_bounce && has_new_impact(contacts_));
    if (!until || (!stops && step_policy::is_too_deep(tick, depth, contacts_.near().depth(), h))) {
        reject_end(tick, h);
    } else if (stops) {
        Motion motion;
        const double share =
            find_impact(tick.model, tick.law, ends, *until, contacts_, motion, end);
        copy_motion(tick.model, motion, result_.end);
        tick.underflows = 0;
        accept_part(tick, h, share);
    } else {
        tick.underflows = 0;
        accept(tick, has_rows, h);
    }
    return SceneStatus::kRunning;
}

// Looks whether boxes meet within a step that are past each other at its end. Returns the share of
// the step at which they do, 1 if none meet, or nothing if the step is too long to be looked at or
// to be stopped there. The near contacts are then those at this share.
std::optional<double> StepControl::look_for_crossing(const Tick& tick, const StepEnds& ends,
                                                     double start_depth) {
    const Kinematics& end = spare_.get().kinematics;
    const int parts =
        contacts_.count_looks(tick.model, tick.law, tick.state.cache().kinematics, end);
    if (parts == 1) return 1.0;
    if (parts > kMostLooks) return std::nullopt;
    const Crossing crossing = find_crossing(tick.model, tick.law, ends, parts, contacts_);
    // Selected contacts are no impacts, but their boxes may pass each other as well.
    if (crossing.depth > start_depth + step_policy::kMaxDeepening) return std::nullopt;
    if (crossing.share < 1.0 && tick.impacts >= kMostStops) return std::nullopt;
    if (crossing.share == 1.0) contacts_.detect(tick.model, tick.law, end);
    return crossing.share;
}

// Tries half of a step of length h, whose end cannot be accepted.
void StepControl::reject_end(Tick& tick, double h) {
    ++tick.state.audit.rejections;
    tick.state.proposed_step = 0.5 * h;
    tick.detected = false;
}

// Computes the accelerations without contact, unless the last step left them.
void StepControl::make_current(Tick& tick) {
    SimulationState& state = tick.state;
    if (state.cache_is_current) return;
    tick.forcing.held = nullptr;
    const MotionSystem system{tick.model, tick.forcing, tick.length};
    system.evaluate(state.motion, tick.time, EvaluationDetail::kEverything, state.cache(),
                    state.free_rate);
    step_policy::count_evaluations(state, 1);
    state.cache_is_current = true;
    state.energy.reset();
}

void StepControl::apply_impact(Tick& tick, double restitution) {
    SimulationState& state = tick.state;
    complete_cache(tick.model, state.cache());
    const ImpactResult impact =
        contacts_.solve_impact(tick.model, tick.law, restitution, state.cache(), state.motion);
    state.audit.impulse_work += impact.work;
    state.audit.positive_work += std::max(0.0, impact.work);
    state.audit.fallbacks += impact.fell_back ? 1U : 0U;
    ++solver_tally_.impacts;
    solver_tally_.impacts_failed += impact.fell_back ? 1U : 0U;
    ++state.audit.events;
    ++tick.impacts;
    state.cache_is_current = false;
    state.has_last_acceleration = false;
    tick.detected = false;
    const ContactSet& touching = contacts_.selected();
    CAMBRIAN_TICK_ASSERT(touching.count <= kMaxContacts, "contacts have room");
    for (int c = 0; c < touching.count; ++c) {
        const double impulse = contacts_.normal_impulse_of(c);
        note_touch(touching.items[c], state);
        state.known_spins &= ~touched_trees(tick.model, touching.items[c]);
        note_impact(tick.model, state.cache().kinematics, touching.items[c], impulse,
                    contacts_.impact_work_of(c), state);
        if (tick.model.measured_parts != 0)
            add_load(tick.model, touching.items[c], impulse, state.forces);
    }
}

double StepControl::choose_length(Tick& tick, bool& has_rows) {
    SimulationState& state = tick.state;
    double h = std::min(state.proposed_step, integrator_->max_step);
    has_rows = contacts_.select_active(tick.model, state.cache(), h);
    if (has_rows) h = std::min(h, limits_.contact_step);
    return step_policy::even_length(tick, limits_, h, has_rows);
}

void StepControl::count_resting(Tick& tick, bool solved) {
    ++solver_tally_.resting;
    if (solved) return;
    ++solver_tally_.resting_failed;
    ++tick.state.audit.fallbacks;
}

StepControl::Attempt StepControl::attempt(Tick& tick, bool has_rows, double& h) {
    const bool midpoint = is_midpoint(has_rows);
    const int order = midpoint ? MidpointStep::kErrorOrder : integrator_->error_order;
    if (!has_rows) contacts_.clear();
    if (has_rows && !midpoint) contacts_.build(tick.model, tick.law, tick.state.cache());
    const Attempt outcome = step_policy::attempt(
        limits_, {order, integrator_->max_step, has_rows}, tick.state, result_, h,
        [&](double length) {
            if (midpoint)
                try_midpoint_step(tick, length);
            else
                try_step(tick, has_rows, length);
        },
        [&](double length) { return must_halve(tick, length); });
    if (outcome != Attempt::kUnderflow) return outcome;
    ++tick.underflows;
    apply_impact(tick, 0.0);
    tick.state.proposed_step = limits_.contact_step;
    return outcome;
}

void StepControl::try_midpoint_step(Tick& tick, double h) {
    SimulationState& state = tick.state;
    tick.forcing.held = nullptr;
    const MotionSystem system{tick.model, tick.forcing, tick.length};
    const StepRequest request{state.motion, state.free_rate, tick.time, h, limits_.tolerance};
    const PerCoordinate& prediction =
        state.has_last_acceleration ? state.last_acceleration : state.free_rate.acceleration;
    count_resting(tick, midpoint_.attempt(system, tick.law, {request, state.cache(), prediction},
                                          contacts_, state.warm, spare_.get(), result_));
    start_rate_ = &midpoint_.mean_rate();
    end_rate_ = start_rate_;
}

// Attempts a step with contact forces that are found at its start and constant over it.
void StepControl::try_step(Tick& tick, bool has_rows, double h) {
    SimulationState& state = tick.state;
    if (has_rows) count_resting(tick, contacts_.solve_resting(tick.model, tick.law, h, state.warm));
    tick.forcing.held = has_rows ? &contacts_.held() : nullptr;
    start_rate_ = has_rows ? &held_start_rate(tick) : &state.free_rate;
    end_rate_ = &result_.end_rate;
    const MotionSystem system{tick.model, tick.forcing, tick.length};
    integrator_->attempt(system, {state.motion, *start_rate_, tick.time, h, limits_.tolerance},
                         spare_.get(), result_);
}

// Computes the accelerations that the constant forces add.
void StepControl::respond_to_held(const Tick& tick, BodyResponse& response) const {
    const EvaluationCache& cache = tick.state.cache();
    Loads loads;
    clear_loads(tick.model, loads);
    add_held_forces(tick.model, contacts_.held(), cache.kinematics, loads);
    solve_impulse(tick.model, cache.kinematics, cache.factors, loads, response);
}

// Returns the accelerations at the start under the constant forces: those without contact plus a
// response.
const MotionRate& StepControl::held_start_rate(Tick& tick) {
    BodyResponse response;
    respond_to_held(tick, response);
    copy_rate(tick.model, tick.state.free_rate, held_rate_);
    for (int c = 0; c < coordinate_count(tick.model); ++c)
        held_rate_.acceleration[c] += response.coordinate[c];
    return held_rate_;
}

// Computes the work of the constant forces up to the end in the spare cache, and the overrun there.
void StepControl::check_step_end(const Tick& tick) {
    const Kinematics& end = spare_.get().kinematics;
    work_ = contacts_.held_work(tick.model, tick.state.cache().kinematics, end);
    end_overrun_ = limit_overrun(tick.model, end);
    end_energy_.reset();
}

// A joint that overruns a limit that was not selected shows that the step is too long, too.
bool StepControl::must_halve(const Tick& tick, double h) {
    check_step_end(tick);
    if (h <= step_policy::kHalvingStep) return false;
    const double weight = tick.model.total_mass * kEarthGravity;
    if (step_policy::gives_energy(work_.positive, result_.error, weight,
                                  [&] { return unexplained_gain(tick); }))
        return true;
    return end_overrun_ > step_policy::kMaxOverrun &&
           end_overrun_ > limit_overrun(tick.model, tick.state.cache().kinematics) +
                              step_policy::kOverrunGrowth;
}

// Returns the energy that the attempted step adds without work, in J.
double StepControl::unexplained_gain(const Tick& tick) {
    const Medium& medium = tick.forcing.medium;
    end_energy_ = mechanical_energy(tick.model, medium, result_.end,
                                    kinetic_energy(tick.model, spare_.get().kinematics));
    double gain = *end_energy_ - mechanical_energy(tick.model, medium, tick.state);
    for (const Work w : {kMotorWork, kDragWork, kPullWork})
        gain -= result_.end.work[w] - tick.state.motion.work[w];
    return gain - work_.contact - work_.limit;
}

void StepControl::accept(Tick& tick, bool has_rows, double h) {
    SimulationState& state = tick.state;
    add_to_audit(tick, h);
    copy_motion(tick.model, result_.end, state.motion);
    state.owned_cache.swap(spare_);
    state.energy = end_energy_;
    copy_rate(tick.model, result_.end_rate, state.free_rate);
    state.has_last_acceleration = is_midpoint(has_rows);
    if (state.has_last_acceleration) {
        const int slots = coordinate_slots(tick.model);
        for (int c = 0; c < slots; c += kLanes)
            store_lanes(state.last_acceleration + c,
                        load_lanes(midpoint_.mean_rate().acceleration + c));
    } else if (has_rows) {
        release_forces(tick);
    }
    tick.time += h;
}

// Accepts the step up to an impact; result_ and the spare cache have the motion there.
void StepControl::accept_part(Tick& tick, double h, double share) {
    SimulationState& state = tick.state;
    check_step_end(tick);
    add_to_audit(tick, share * h);
    copy_motion(tick.model, result_.end, state.motion);
    state.cache_is_current = false;
    tick.time += share * h;
}

// Subtracts the response to the constant forces from the accelerations of the step's end.
void StepControl::release_forces(Tick& tick) {
    SimulationState& state = tick.state;
    complete_cache(tick.model, state.cache());
    BodyResponse response;
    respond_to_held(tick, response);
    for (int c = 0; c < coordinate_count(tick.model); ++c) {
        state.free_rate.acceleration[c] -= response.coordinate[c];
        state.cache().response.coordinate[c] -= response.coordinate[c];
    }
    for (int i = 0; i < tick.model.body_count; ++i) {
        state.cache().response.x[i] -= response.x[i];
        state.cache().response.y[i] -= response.y[i];
        state.cache().response.spin[i] -= response.spin[i];
    }
}

// Adds a step of `time` (s) to the audit.
void StepControl::add_to_audit(Tick& tick, double time) {
    SimulationState& state = tick.state;
    SceneAudit& audit = state.audit;
    audit.contact_work += work_.contact;
    audit.limit_work += work_.limit;
    audit.positive_work += work_.positive;
    ++audit.steps;
    note_depths(contacts_.near(), end_overrun_, audit);
    if (tick.model.member_count > 1)
        note_member_works(tick.model, state.cache(), spare_.get(), time, state);
    const ContactSet& selected = contacts_.selected();
    for (int c = 0; c < selected.count; ++c) {
        const Contact& contact = selected.items[c];
        if (contact.gap >= kContactBand && contacts_.held_normal(c) <= 0.0) continue;
        note_touch(contact, state);
        if (tick.model.measured_parts != 0)
            add_load(tick.model, contact, time * contacts_.held_normal(c), state.forces);
    }
}

void StepControl::remember_contacts(Tick& tick) {
    SimulationState& state = tick.state;
    state.held_count = 0;
    const ContactSet& selected = contacts_.selected();
    for (int c = 0; c < contacts_.held().contact_count; ++c) {
        const Contact& contact = selected.items[c];
        const double force = contacts_.held_normal(c);
        if (force <= 0.0) continue;
        CAMBRIAN_TICK_ASSERT(state.held_count < kMaxContacts, "held contacts have room");
        state.held[state.held_count++] = {contact.body_a,   contact.point_x,  contact.point_y,
                                          contact.normal_x, contact.normal_y, force};
    }
}

SceneStatus StepControl::status_of(const Tick& tick) {
    const Motion& motion = tick.state.motion;
    Simd4i sound = Simd4d{} <= Simd4d{};
    const int slots = coordinate_slots(tick.model);
    for (int c = 0; c < slots; c += kLanes) {
        sound &= magnitude(load_lanes(motion.position + c)) <= all_lanes(step_policy::kMaxDistance);
        sound &= magnitude(load_lanes(motion.speed + c)) <= all_lanes(step_policy::kMaxSpeed);
    }
    const bool is_sound = (sound[0] & sound[1] & sound[2] & sound[3]) != 0;
    return is_sound ? SceneStatus::kRunning : SceneStatus::kInvalid;
}

}  // namespace cambrian
