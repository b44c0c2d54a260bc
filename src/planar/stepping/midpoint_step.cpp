#include "planar/stepping/midpoint_step.h"

#include "dynamics/step_policy.h"
#include "planar/articulated/articulated_body.h"
#include "planar/constraints/invariants.h"
#include "planar/evaluation/accelerations.h"
#include "planar/evaluation/cache_numbers.h"

#include <cmath>

namespace cambrian {
namespace {

// Accelerations of the joints' coordinates, four at once.
CAMBRIAN_INLINE Simd4d joint_accelerations(const PlanarModel& model, const double* coordinate,
                                           const double* spin, int first) {
    const Simd4d turning = all_lanes(1.0) - load_lanes(model.slides + first);
    return load_lanes(coordinate + first) - turning * gather(spin, model.parent_slot + first);
}

// RMS over all coordinates of the errors of position / (0.1 m or rad) and of speed / (1 + |speed|).
CAMBRIAN_INLINE double error_norm(const PlanarModel& model, const Motion& end,
                                  const PerCoordinate& position_error,
                                  const PerCoordinate& speed_error) {
    Simd4d sum = {};
    const int slots = coordinate_slots(model);
    for (int c = 0; c < slots; c += kLanes) {
        const Simd4d position = step_policy::kPerPosition * load_lanes(position_error + c);
        const Simd4d size = 1.0 + magnitude(load_lanes(end.speed + c));
        const Simd4d speed = load_lanes(speed_error + c) / size;
        sum += position * position + speed * speed;
    }
    return std::sqrt(sum_of(sum) / (2.0 * coordinate_count(model)));
}

// Computes the motion after a time of constant accelerations.
CAMBRIAN_INLINE void accelerate(const PlanarModel& model, const Motion& start, double time,
                                const PerCoordinate& acceleration, Motion& end) {
    const int slots = coordinate_slots(model);
    for (int c = 0; c < slots; c += kLanes) {
        const Simd4d change = time * load_lanes(acceleration + c);
        const Simd4d speed = load_lanes(start.speed + c);
        store_lanes(end.speed + c, speed + change);
        store_lanes(end.position + c,
                    load_lanes(start.position + c) + time * (speed + 0.5 * change));
    }
}

CAMBRIAN_INLINE void add_jumps(const PlanarModel& model, const PerCoordinate (&jumps)[2],
                               PerCoordinate (&errors)[2]) {
    const int slots = coordinate_slots(model);
    for (int which = 0; which < 2; ++which) {
        for (int c = 0; c < slots; c += kLanes)
            store_lanes(errors[which] + c,
                        load_lanes(errors[which] + c) + load_lanes(jumps[which] + c));
    }
}

}  // namespace

void MidpointStep::clear_beyond(const ChangedCounts& counts) {
    Clearing clearing;
    visit_motion(predicted_, counts, clearing);
    visit_cache(middle_, counts, clearing);
    visit_rate(middle_rate_, counts, clearing);
    visit_response(held_, counts, clearing);
    visit_rate(mean_rate_, counts, clearing);
}

bool MidpointStep::attempt(const MotionSystem& system, const ContactLaw& law,
                           const MidpointRequest& request, ContactSolver& contacts, WarmStart& warm,
                           EvaluationCache& cache, StepResult& result) {
    const PlanarModel& model = system.model;
    const StepRequest& step = request.step;
    const double half = 0.5 * step.length;
    CAMBRIAN_TICK_ASSERT(step.length > 0.0 && step.tolerance > 0.0, "a step takes time");
    accelerate(model, step.start, half, request.prediction, predicted_);
    const ImplicitStage stage{half, request.start.kinematics.joint_rate};
    const bool touches = contacts.selected().count > 0;
    system.evaluate(predicted_, step.time + half,
                    touches ? EvaluationDetail::kEverything : EvaluationDetail::kAccelerations,
                    middle_, middle_rate_, &stage);
    if (touches) find_centers(model, middle_);
    contacts.build_between(model, law, request.start.kinematics, middle_);
    const bool solved = contacts.solve_resting(model, law, step.length, warm);
    if (contacts.holds_something())
        respond(model, contacts, step.length);
    else
        respond_to_nothing(model);
    const int slots = coordinate_slots(model);
    for (int c = 0; c < slots; c += kLanes)
        store_lanes(mean_rate_.acceleration + c,
                    load_lanes(middle_rate_.acceleration + c) + load_lanes(held_.coordinate + c));
    accelerate(model, step.start, step.length, mean_rate_.acceleration, result.end);
    system.evaluate(result.end, step.time + step.length, EvaluationDetail::kEverything, cache,
                    result.end_rate);
    integrate_works(model, request, cache, result);
    result.error = estimate_error(model, law, step, contacts, result);
    result.evaluations = 2;
    CAMBRIAN_TICK_ASSERT(is_not_negative(result.error), "an error is not negative");
    return solved;
}

void MidpointStep::respond(const PlanarModel& model, const ContactSolver& contacts, double h) {
    Loads loads;
    clear_loads(model, loads);
    contacts.add_held(h, loads);
    if (middle_.is_inverted) {
        solve_dense_impulse(model, middle_, loads, held_.coordinate);
        for (int i = 0; i < model.body_count; i += kLanes)
            store_lanes(held_.spin + i, load_lanes(held_.coordinate + i));
    } else {
        solve_impulse(model, middle_.kinematics, middle_.factors, loads, held_);
        for (int c = coordinate_count(model); c < coordinate_slots(model); ++c)
            held_.coordinate[c] = 0.0;
    }
}

void MidpointStep::respond_to_nothing(const PlanarModel& model) {
    const int slots = coordinate_slots(model);
    for (int c = 0; c < slots; c += kLanes)
        store_lanes(held_.coordinate + c, Simd4d{});
    for (int i = 0; i < model.body_count; i += kLanes)
        store_lanes(held_.spin + i, Simd4d{});
}

// Integrates the works. That of motors is exact, because their efforts are constant; those of drag
// and pull use Simpson's rule.
void MidpointStep::integrate_works(const PlanarModel& model, const MidpointRequest& request,
                                   const EvaluationCache& cache, StepResult& result) {
    const StepRequest& step = request.step;
    PerBody spin;
    for (int i = 0; i < model.body_count; i += kLanes)
        store_lanes(spin + i, load_lanes(middle_.response.spin + i) + load_lanes(held_.spin + i));
    Simd4d net = {};
    Simd4d gross = {};
    for (int i = 0; i < model.body_count; i += kLanes) {
        const Simd4d effort = load_lanes(middle_.motor_effort + i) -
                              load_lanes(middle_.motor_damping + i) *
                                  joint_accelerations(model, mean_rate_.acceleration, spin, i);
        const Simd4d work = effort * (load_lanes(cache.kinematics.joint_position + i) -
                                      load_lanes(request.start.kinematics.joint_position + i));
        net += work;
        gross += magnitude(work);
    }
    double* work = result.end.work;
    const double* before = step.start.work;
    work[kMotorWork] = before[kMotorWork] + sum_of(net);
    work[kGrossMotorWork] = before[kGrossMotorWork] + sum_of(gross);
    for (const Work w : {kDragWork, kPullWork, kSpinGiven})
        work[w] = before[w] + step.length / 6.0 *
                                  (step.start_rate.power[w] + 4.0 * middle_rate_.power[w] +
                                   result.end_rate.power[w]);
    for (int w = 0; w < kWorkCount; ++w)
        mean_rate_.power[w] = (work[w] - before[w]) / step.length;
}

// The error is the distance to Simpson's rule for speeds and to Hermite's rule for positions:
// h/6 (a0 - 2 am + a1) and h^2/12 (a1 - a0) (planar/README.md 13). All three accelerations are
// free of contact. The part that active rows would undo is projected away, because contact forces
// absorb it. Implicit motors damp the error as they damp the motion. A small error is not
// projected.
double MidpointStep::estimate_error(const PlanarModel& model, const ContactLaw& law,
                                    const StepRequest& step, ContactSolver& contacts,
                                    const StepResult& result) const {
    const double h = step.length;
    PerCoordinate errors[2];   // of speeds, then of positions
    PerCoordinate changes[2];  // changes that the motors damp
    const int slots = coordinate_slots(model);
    for (int c = 0; c < slots; c += kLanes) {
        const Simd4d start = load_lanes(step.start_rate.acceleration + c);
        const Simd4d end = load_lanes(result.end_rate.acceleration + c);
        const Simd4d middle = load_lanes(middle_rate_.acceleration + c);
        store_lanes(errors[0] + c, (h / 6.0) * (start + end - 2.0 * middle));
        store_lanes(changes[0] + c,
                    (h / 6.0) * (start + end - 2.0 * load_lanes(mean_rate_.acceleration + c)));
        const Simd4d position = (h * h / 12.0) * (end - start);
        store_lanes(errors[1] + c, position);
        store_lanes(changes[1] + c, position);
    }
    take_damping(model, changes, errors);
    const double scale = step_policy::kCaution / step.tolerance;
    const double whole = scale * error_norm(model, result.end, errors[1], errors[0]);
    if (whole <= step_policy::kCalmError) return whole;
    if (!take_absorbed(model, law, contacts, errors)) return whole;
    return scale * error_norm(model, result.end, errors[1], errors[0]);
}

// Adds to the errors the response to the damping of implicit motors under changes of speeds.
void MidpointStep::take_damping(const PlanarModel& model, const PerCoordinate (&changes)[2],
                                PerCoordinate (&errors)[2]) const {
    PerBody efforts[2];
    PerCoordinate jumps[2];
    for (int which = 0; which < 2; ++which) {
        if (middle_.is_inverted) {
            damp(model, changes[which], changes[which], efforts[which]);
            solve_dense_efforts(model, middle_, efforts[which], jumps[which]);
        } else {
            PerBody spin;
            spread_spins(model, changes[which], spin);
            damp(model, changes[which], spin, efforts[which]);
        }
    }
    if (!middle_.is_inverted)
        solve_paired_efforts(model, middle_.kinematics, middle_.factors, efforts, jumps);
    add_jumps(model, jumps, errors);
}

// Computes the efforts of the motors' damping against changes of the coordinates' speeds.
CAMBRIAN_INLINE void MidpointStep::damp(const PlanarModel& model, const PerCoordinate& change,
                                        const double* spin, PerBody& efforts) const {
    for (int i = 0; i < model.body_count; i += kLanes)
        store_lanes(efforts + i, -load_lanes(middle_.motor_damping + i) *
                                     joint_accelerations(model, change, spin, i));
}

// Subtracts from the errors the part that active rows absorb. Stops need the spins alone. Returns
// false if there is no such part.
bool MidpointStep::take_absorbed(const PlanarModel& model, const ContactLaw& law,
                                 ContactSolver& contacts, PerCoordinate (&errors)[2]) const {
    const Kinematics& k = middle_.kinematics;
    Loads loads[2];
    BodyResponse changes[2];
    for (int which = 0; which < 2; ++which) {
        BodyResponse& change = changes[which];
        const int slots = coordinate_slots(model);
        for (int c = 0; c < slots; c += kLanes)
            store_lanes(change.coordinate + c, load_lanes(errors[which] + c));
        if (contacts.selected().count == 0)
            spread_spins(model, errors[which], change.spin);
        else if (middle_.is_inverted)
            spread_dense_rates(model, k, errors[which], change.spin, change.x, change.y);
        else
            spread_rates(model, k, errors[which], change.spin, change.x, change.y);
        clear_loads(model, loads[which]);
    }
    if (!contacts.absorb(model, law, changes, loads)) return false;
    add_responses(model, loads, errors);
    return true;
}

// Adds the responses of the coordinates to the loads in the middle of the step.
void MidpointStep::add_responses(const PlanarModel& model, const Loads (&loads)[2],
                                 PerCoordinate (&errors)[2]) const {
    PerCoordinate jumps[2];
    if (middle_.is_inverted) {
        for (int which = 0; which < 2; ++which)
            solve_dense_impulse(model, middle_, loads[which], jumps[which]);
    } else {
        solve_paired_impulses(model, middle_.kinematics, middle_.factors, loads, jumps);
    }
    add_jumps(model, jumps, errors);
}

}  // namespace cambrian
