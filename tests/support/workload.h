#pragma once

// The three settings creatures are timed and compared in.

#include "world/environment.h"

#include <string>
#include <vector>

namespace cambrian {

struct Workload {
    std::string id;  // "air", "swim", "walk"
    Environment environment;
};

std::vector<Workload> all_workloads();

}  // namespace cambrian
