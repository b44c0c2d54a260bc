#pragma once

// When contacts touch, rest or bounce, and how the moment of an impact is looked for, in the plane
// and in space (planar/README.md 8 and 12).

#include "core/assert.h"

namespace cambrian {

inline constexpr double kContactBand = 1e-3;    // m; smaller gaps count as touching
inline constexpr double kRestingGap = 0.5e-3;   // m; gap of resting contacts
inline constexpr double kRestingSpeed = 0.3;    // m/s; slower contacts do not bounce
inline constexpr double kContactMargin = 0.02;  // m; points with larger gaps are ignored

inline constexpr double kPushSpeed = 0.5;       // m/s; fastest way back out of the ground
inline constexpr double kStopPushSpeed = 1.0;   // rad/s or m/s; from beyond a stop
inline constexpr double kAnchorWeights = 10.0;  // weights of a creature; largest anchored force

// The deepest new contact that is an impact.
struct NewContact {
    bool found = false;
    double gap = kContactMargin;  // m
    double closing_speed = 0.0;   // m/s
};

// Whether a contact closes fast or penetrates too deeply.
inline bool is_impact(double gap, double closing_speed) {
    const bool fast = closing_speed > kRestingSpeed;
    // A fast spinning corner may enter the ground and leave it again within one step.
    const bool deep = gap < -kContactBand;
    return fast || deep;
}

// Returns the next guess of the share of a step (of that length, s) at which it meets an impact,
// between two shares: it puts the contact that was seen at `from` into the middle of the band at
// its closing speed. It remains well inside the bracket.
inline double next_share(double low, double high, double from, const NewContact& seen,
                         double length) {
    CAMBRIAN_TICK_ASSERT(low >= 0.0 && low <= high && high <= 1.0, "a bracket within the step");
    const double middle = 0.5 * (low + high);
    if (!seen.found || seen.closing_speed <= kRestingSpeed) return middle;
    const double guess = from + (seen.gap - kRestingGap) / (seen.closing_speed * length);
    const double rim = 0.02 * (high - low);
    return guess > low + rim && guess < high - rim ? guess : middle;
}

}  // namespace cambrian
