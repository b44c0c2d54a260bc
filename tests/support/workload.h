#pragma once

// The three worlds in which creatures are timed and compared.

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
