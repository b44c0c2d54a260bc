#pragma once

// Energy as a count of 1e-9 J, so that sums are exact and independent of their order.

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace cambrian {

using Energy = std::int64_t;  // 1e-9 J

inline constexpr double kEnergyUnits = 1e9;  // a joule

inline constexpr double kMostJoules = 2e9;  // of one amount, so that sums of a few do not overflow

// Returns an amount in J as an energy, rounded down; it is limited to 0 to kMostJoules.
inline Energy energy_of(double joules) {
    return static_cast<Energy>(std::floor(std::clamp(joules, 0.0, kMostJoules) * kEnergyUnits));
}

inline double joules(Energy energy) {
    return static_cast<double>(energy) / kEnergyUnits;
}

// Returns a share in [0, 1] of an energy, rounded down.
inline Energy share_of(Energy energy, double share) {
    const double part = std::floor(static_cast<double>(energy) * share);
    return std::min(energy, static_cast<Energy>(part));  // large numbers round up as doubles
}

}  // namespace cambrian
