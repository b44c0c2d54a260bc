#include "spatial/time_of_impact.h"

namespace cambrian::spatial {
namespace {

constexpr int kMostRounds = 40;

NewContact deepest_new_contact(const ContactSet& near, const Rows& selected) {
    NewContact deepest;
    for (int c = 0; c < near.count; ++c) {
        const Contact& contact = near.items[c];
        if (!is_impact(contact.gap, contact.closing_speed()) || contact.gap >= deepest.gap)
            continue;
        if (selected.covers(contact)) continue;
        deepest = {true, contact.gap, contact.closing_speed()};
    }
    return deepest;
}

}  // namespace

void interpolate_motion(const Model& model, const StepEnds& step, double share, Motion& motion) {
    const double t = share;
    const double t2 = t * t;
    const double blend = t2 * (3.0 - 2.0 * t);
    const double start = step.length * t * (1.0 + t * (-2.0 + t));
    const double end = step.length * t2 * (t - 1.0);
    const auto between = [&](double from, double to, double from_rate, double to_rate) {
        return from + blend * (to - from) + start * from_rate + end * to_rate;
    };
    copy_attitudes(model, step.start, motion);
    for (int c = 0; c < model.coordinate_count(); ++c) {
        motion.position[c] = between(step.start.position[c], step.end.position[c],
                                     step.start_rate.position[c], step.end_rate.position[c]);
        motion.speed[c] = between(step.start.speed[c], step.end.speed[c], step.start_rate.speed[c],
                                  step.end_rate.speed[c]);
    }
    for (int w = 0; w < kWorkCount; ++w)
        motion.work[w] = between(step.start.work[w], step.end.work[w], step.start_rate.power[w],
                                 step.end_rate.power[w]);
}

bool has_new_impact(const ContactSet& near, const Rows& selected) {
    return deepest_new_contact(near, selected).gap < 0.0;
}

double find_impact(const Model& model, const StepEnds& step, const Rows& selected, ContactSet& near,
                   Motion& motion, Kinematics& kinematics) {
    const auto look = [&](double share) {
        interpolate_motion(model, step, share, motion);
        compute_kinematics(model, motion, kinematics);
        detect_contacts(model, step.has_ground, motion, kinematics, near);
        return deepest_new_contact(near, selected);
    };
    double low = 0.0;
    double high = 1.0;
    double share = next_share(low, high, high, deepest_new_contact(near, selected), step.length);
    for (int round = 0; round < kMostRounds; ++round) {
        const NewContact deepest = look(share);
        if (deepest.found && deepest.gap >= 0.0 && deepest.gap <= kContactBand) return share;
        (deepest.gap < 0.0 ? high : low) = share;
        share = next_share(low, high, share, deepest, step.length);
    }
    look(high);
    return high;
}

}  // namespace cambrian::spatial
