#pragma once

#include "evolution/fields/setting_field.h"
#include "evolution/kinds/evolution_kinds.h"
#include "evolution/settings/experiment_settings.h"

#include <span>
#include <string_view>

namespace cambrian {

// Values for one table of settings and those below it, to choose in one go.
struct SettingPreset {
    std::string_view table;  // "environment", "mutation", "trial"
    const char* label;
    const char* help;
    void (*apply)(ExperimentSettings& settings, const EvolutionKinds& kinds);
};

// Those of one table are adjacent.
std::span<const SettingPreset> setting_presets();
std::span<const SettingPreset> setting_presets(std::string_view table);

// Whether applying it would change nothing.
bool is_in_force(const SettingPreset& preset, const ExperimentSettings& settings,
                 const EvolutionKinds& kinds, const std::vector<SettingField>& fields);

}  // namespace cambrian
