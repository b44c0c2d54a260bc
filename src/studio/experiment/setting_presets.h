#pragma once

#include "evolution/evolution_kinds.h"
#include "evolution/experiment_settings.h"
#include "evolution/setting_field.h"

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

// Those of one table stand together.
std::span<const SettingPreset> setting_presets();
std::span<const SettingPreset> setting_presets(std::string_view table);

// Whether applying it would change nothing.
bool is_in_force(const SettingPreset& preset, const ExperimentSettings& settings,
                 const EvolutionKinds& kinds, const std::vector<SettingField>& fields);

}  // namespace cambrian
