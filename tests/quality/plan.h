#pragma once

// Which runs make up a benchmark (quality/README.md 1 and 3).

#include "quality/run.h"

#include <string_view>

namespace cambrian::quality {

// "standard": every arm on 3000 evaluations, seeds 1 to 9. "long": evolution against random search
// on 20 000, seeds 1 to 5. "quick": the same on 900, seeds 1 to 9. Empty for another name. Ordered
// so that what is known after a part of it is as balanced as can be.
std::vector<RunSpec> plan_of(std::string_view name);

}  // namespace cambrian::quality
