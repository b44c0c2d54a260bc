#include "planar/stepping/time_of_impact.h"

#include "core/assert.h"

#include <algorithm>
#include <cmath>

namespace cambrian {
namespace {

constexpr int kMaxRounds = 40;

NewContact deepest_new_contact(const ContactSolver& contacts) {
    NewContact deepest;
    const ContactSet& near = contacts.near();
    for (int c = 0; c < near.count; ++c) {
        const Contact& contact = near.items[c];
        if (!is_impact(contact.gap, contact.closing_speed) || contact.gap >= deepest.gap) continue;
        CAMBRIAN_TICK_ASSERT(!(contact.gap > kContactMargin), "a near contact");
        if (contacts.covers(contact)) continue;
        deepest = {true, contact.gap, contact.closing_speed};
    }
    return deepest;
}

}  // namespace

bool has_new_impact(const ContactSolver& contacts) {
    return deepest_new_contact(contacts).gap < 0.0;
}

Crossing find_crossing(const PlanarModel& model, const ContactLaw& law, const StepEnds& step,
                       int parts, ContactSolver& contacts) {
    CAMBRIAN_TICK_ASSERT(parts > 1, "something to look at");
    Motion motion;
    Kinematics kinematics = {};
    Crossing crossing;
    for (int look = 1; look < parts; ++look) {
        const double share = static_cast<double>(look) / parts;
        interpolate_motion(coordinate_slots(model), step, share, motion);
        compute_kinematics(model, motion, kinematics);
        contacts.detect(model, law, kinematics);
        bool is_new = false;
        for (int c = 0; c < contacts.near().count; ++c) {
            const Contact& contact = contacts.near().items[c];
            if (is_on_ground(contact) || contact.gap >= 0.0) continue;
            if (contacts.covers(contact))
                crossing.depth = std::max(crossing.depth, -contact.gap);
            else
                is_new = is_new || is_impact(contact.gap, contact.closing_speed);
        }
        if (!is_new) continue;
        crossing.share = share;
        break;
    }
    return crossing;
}

double find_impact(const PlanarModel& model, const ContactLaw& law, const StepEnds& step,
                   double until, ContactSolver& contacts, Motion& motion, Kinematics& kinematics) {
    CAMBRIAN_TICK_ASSERT(step.length > 0.0, "a step takes time");
    double low = 0.0;
    double high = until;
    double share = next_share(low, high, until, deepest_new_contact(contacts), step.length);
    for (int round = 0; round < kMaxRounds; ++round) {
        interpolate_motion(coordinate_slots(model), step, share, motion);
        compute_kinematics(model, motion, kinematics);
        contacts.detect(model, law, kinematics);
        const NewContact deepest = deepest_new_contact(contacts);
        if (deepest.found && deepest.gap >= 0.0 && deepest.gap <= kContactBand) return share;
        (deepest.gap < 0.0 ? high : low) = share;
        share = next_share(low, high, share, deepest, step.length);
    }
    interpolate_motion(coordinate_slots(model), step, high, motion);
    compute_kinematics(model, motion, kinematics);
    contacts.detect(model, law, kinematics);
    return high;
}

void interpolate_motion(int slots, const StepEnds& step, double share, Motion& motion) {
    CAMBRIAN_TICK_ASSERT(share >= 0.0 && share <= 1.0, "a place within the step");
    CAMBRIAN_TICK_ASSERT(step.length > 0.0, "a step takes time");
    const double h = step.length;
    const double t = share;
    const double t2 = t * t;
    const double t3 = t2 * t;
    const double blend = t3 * (10.0 + t * (-15.0 + 6.0 * t));
    const double start_speed = h * t * (1.0 + t2 * (-6.0 + t * (8.0 - 3.0 * t)));
    const double end_speed = h * t3 * (-4.0 + t * (7.0 - 3.0 * t));
    const double start_turn = 0.5 * h * h * t2 * (1.0 + t * (-3.0 + t * (3.0 - t)));
    const double end_turn = 0.5 * h * h * t3 * (1.0 + t * (-2.0 + t));
    const double rate_blend = t2 * (3.0 - 2.0 * t);
    const double rate_start = h * t * (1.0 + t * (-2.0 + t));
    const double rate_end = h * t2 * (t - 1.0);
    for (int c = 0; c < slots; ++c) {
        const double a0 = step.start_rate.acceleration[c];
        const double a1 = step.end_rate.acceleration[c];
        const double v0 = step.start.speed[c];
        const double v1 = step.end.speed[c];
        const double q0 = step.start.position[c];
        motion.position[c] = q0 + blend * (step.end.position[c] - q0) + start_speed * v0 +
                             end_speed * v1 + start_turn * a0 + end_turn * a1;
        motion.speed[c] = v0 + rate_blend * (v1 - v0) + rate_start * a0 + rate_end * a1;
    }
    for (int w = 0; w < kWorkCount; ++w) {
        const double p0 = step.start_rate.power[w];
        const double rise = step.end_rate.power[w] - p0;
        const double mean = (step.end.work[w] - step.start.work[w]) / h;
        const double square = 6.0 * (p0 + 0.5 * rise - mean);
        const double slope = rise - square;
        motion.work[w] = step.start.work[w] + h * t * (p0 + t * (0.5 * slope + t * square / 3.0));
    }
}

}  // namespace cambrian
