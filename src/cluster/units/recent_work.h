#pragma once

// The work of a machine in the last minute.

#include "core/recent_sum.h"

#include <cstdint>

namespace cambrian {

inline constexpr int kRateSeconds = 10;  // s over which rates are averaged

struct RecentWork {
    RecentSum creatures;
    RecentSum work;  // evaluations of accelerations

    void add(double now, std::uint64_t more_creatures, std::uint64_t more_work) {
        creatures.add(static_cast<double>(more_creatures), now);
        work.add(static_cast<double>(more_work), now);
    }
    double creatures_per_second(double now) const { return creatures.rate(now, kRateSeconds); }
    double work_per_second(double now) const { return work.rate(now, kRateSeconds); }
};

}  // namespace cambrian
