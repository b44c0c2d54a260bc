#pragma once

// The three settings creatures are timed in (physics.md 12).

#include "world/environment.h"

#include <string>
#include <vector>

namespace cambrian::bench {

inline constexpr double kTick = 1.0 / 60.0;  // s; how often targets change

struct Workload {
    std::string id;  // "air", "swim", "walk"
    Environment environment;
};

std::vector<Workload> all_workloads();

}  // namespace cambrian::bench
