#pragma once

// Arms that differ in the value of one setting.

#include "comparison/plan.h"
#include "core/result.h"

#include <string>
#include <vector>

namespace cambrian {

// Returns every arm once for each value of the setting, as typed: "selection.method", or "method"
// if only one table has such a key. A single arm gives its place to names like
// "selection.method=rank". Fails for a setting that does not exist.
Result<std::vector<NamedSettings>> swept_arms(const std::vector<NamedSettings>& arms,
                                              const std::string& key,
                                              const std::vector<std::string>& values,
                                              const EvolutionKinds& kinds);

}  // namespace cambrian
