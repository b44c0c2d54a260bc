#pragma once

#include "persist/settings/settings_file.h"

namespace cambrian {

// A setting as a person types it: "selection.method=rank", or "method=rank" where only one table
// has such a key. Texts need no quotes. Its value is checked where it is merged.
Result<SettingsText> typed_setting(std::string_view assignment, const EvolutionKinds& kinds);

// The settings with these changes, one after the other.
Result<ExperimentSettings> with_typed(ExperimentSettings settings,
                                      const std::vector<std::string>& assignments,
                                      const EvolutionKinds& kinds);

}  // namespace cambrian
