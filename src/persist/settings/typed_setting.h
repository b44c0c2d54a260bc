#pragma once

#include "persist/settings/settings_file.h"

namespace cambrian {

// Parses a setting as typed by a user: "selection.method=rank", or "method=rank" if only one table
// has such a key. Texts need no quotes. The value is checked when it is merged.
Result<SettingsText> typed_setting(std::string_view assignment, const EvolutionKinds& kinds);

// Returns the settings of a text after these changes, made in order. What neither says has its
// default, which may depend on the goal.
Result<ExperimentSettings> merge_typed(SettingsText begin,
                                       const std::vector<std::string>& assignments,
                                       const EvolutionKinds& kinds);

// Returns the settings after these changes, made in order.
Result<ExperimentSettings> with_typed(ExperimentSettings settings,
                                      const std::vector<std::string>& assignments,
                                      const EvolutionKinds& kinds);

}  // namespace cambrian
