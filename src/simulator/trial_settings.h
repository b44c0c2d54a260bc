#pragma once

#include <string>

namespace cambrian {

// The protocol of one trial (simulator/README.md 1) and the guards that end dishonest ones (2).
struct TrialSettings {
    double duration = 15.0;          // s, of the test phase
    double settle_limit = 3.0;       // s, at most, before the test; with ground only
    bool settle_motors_off = false;  // settling without torque and friction instead of at rest pose
    double max_part_speed = 30.0;    // m/s; faster is invalid
    double max_part_spin = 60.0;     // rad/s
    double max_ground_depth = 0.05;  // m; deeper for over 0.2 s is invalid
    double max_reversal_rate = 5.0;  // Hz; the score of faster shaking is scaled down
    bool stop_at_rest = true;        // once nothing moves or could move again (section 3)
    int trials = 1;                  // the first in the world as it is, further ones with jitter:
    double friction_jitter = 0.0;    // share of the friction, either way
    double tilt_jitter = 0.0;        // degrees of the start pose, either way
    std::string combine = "mean";    // or "minimum": what the trials' scores come to

    friend bool operator==(const TrialSettings&, const TrialSettings&) = default;
};

inline constexpr double kBrainTick = 1.0 / 60.0;  // s
inline constexpr int kTicksPerSample = 6;         // samples every 0.1 s

}  // namespace cambrian
