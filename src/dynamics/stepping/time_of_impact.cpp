#include "dynamics/stepping/time_of_impact.h"

#include "core/assert.h"

#include <cmath>

namespace cambrian {
namespace {

constexpr int kMaxRounds = 40;

// The deepest new contact that closes fast or penetrates too deeply.
struct NewContact {
    bool found = false;
    double gap = kContactMargin;
    double closing_speed = 0.0;
};

NewContact deepest_new_contact(const ContactSolver& contacts) {
    NewContact deepest;
    const ContactSet& near = contacts.near();
    for (int c = 0; c < near.count; ++c) {
        const Contact& contact = near.items[c];
        const bool fast = contact.closing_speed > kRestingSpeed;
        // A fast spinning corner may enter the ground and leave it again within one step.
        const bool deep = contact.gap < -kContactBand;
        if (!(fast || deep) || contact.gap >= deepest.gap) continue;
        CAMBRIAN_TICK_ASSERT(!(contact.gap > kContactMargin), "a near contact");
        if (contacts.covers(contact)) continue;
        deepest = {true, contact.gap, contact.closing_speed};
    }
    return deepest;
}

// The next guess puts the last contact into the middle of the band at its closing speed. It remains
// well inside the bracket.
double next_share(double low, double high, double from, const NewContact& seen, double length) {
    CAMBRIAN_TICK_ASSERT(low >= 0.0 && low <= high && high <= 1.0, "a bracket within the step");
    const double middle = 0.5 * (low + high);
    if (!seen.found || seen.closing_speed <= kRestingSpeed) return middle;
    const double guess = from + (seen.gap - kRestingGap) / (seen.closing_speed * length);
    const double rim = 0.02 * (high - low);
    return guess > low + rim && guess < high - rim ? guess : middle;
}

}  // namespace

bool has_new_impact(const ContactSolver& contacts) {
    return deepest_new_contact(contacts).gap < 0.0;
}

double find_impact(const PlanarModel& model, const ContactLaw& law, const StepEnds& step,
                   ContactSolver& contacts, Motion& motion, Kinematics& kinematics) {
    CAMBRIAN_TICK_ASSERT(step.length > 0.0, "a step takes time");
    double low = 0.0;
    double high = 1.0;
    double share = next_share(low, high, 1.0, deepest_new_contact(contacts), step.length);
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

}  // namespace cambrian
