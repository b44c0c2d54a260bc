#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

namespace cambrian {

// "worse half" is 0.1 times the mean and 0.9 times the mean of the worse half: who is good only at
// some of the trials gains little, yet every gain counts.
inline constexpr std::array<std::string_view, 3> kCombineIds = {"mean", "minimum", "worse half"};

// The protocol of a trial (simulator/README.md 1) and the guards that end invalid ones (2).
struct TrialSettings {
    double duration = 15.0;     // s, length of the test phase
    double settle_limit = 3.0;  // s, longest settling before the test; only with ground
    // Settles without torque and friction instead of in the rest pose.
    bool settle_motors_off = false;
    double max_part_speed = 30.0;    // m/s; faster is invalid
    double max_part_spin = 60.0;     // rad/s
    double max_ground_depth = 0.05;  // m; deeper for over 0.2 s is invalid
    double max_reversal_rate = 5.0;  // Hz; above it the score is scaled down
    bool stop_at_rest = true;        // ends a trial when nothing can move again (section 3)
    bool has_cube = false;           // a free cube to fight for (section 7)
    int trials = 1;                // the first is in the unchanged world, further ones have jitter:
    double friction_jitter = 0.0;  // share of the friction, in both directions
    double tilt_jitter = 0.0;      // degrees of the start pose, in both directions
    std::string combine = "mean";  // how the trials' scores are combined: one of kCombineIds
    int renewal = 0;               // generations after which chance is drawn again; 0 for never
    int draw = 0;                  // number of times chance was drawn again

    friend bool operator==(const TrialSettings&, const TrialSettings&) = default;
};

inline constexpr double kBrainTick = 1.0 / 60.0;  // s
inline constexpr double kStartClearance = 0.02;   // m, lowest corner above ground
inline constexpr int kTicksPerSample = 6;         // samples every 0.1 s

// Returns the kinetic energy, in J, below which a creature of so many parts is calm.
inline double calm_energy(std::size_t parts) {
    return 0.001 * static_cast<double>(parts);
}
// The same of a creature in space with this mass, kg: at 0.14 m/s.
inline double calm_energy_in_space(double mass) {
    return 0.01 * mass;
}

}  // namespace cambrian
