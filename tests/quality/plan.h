#pragma once

// The runs of a benchmark (quality/README.md 1 and 3).

#include "quality/run.h"

#include <string_view>

namespace cambrian::quality {

// Returns the runs of a plan. "standard" has every arm with 3000 evaluations and seeds 1 to 9.
// "long" compares evolution with random search, with 20 000 evaluations and seeds 1 to 5; "quick"
// does so for swimming with 900 and for walking with 450, and seeds 1 to 9. "seeking" compares a
// light that can be seen, one that cannot and random search, with 20 000 evaluations and seeds
// 1 to 5. For other names it is empty. A finished part of the plan is as balanced as possible.
std::vector<RunSpec> plan_of(std::string_view name);

}  // namespace cambrian::quality
