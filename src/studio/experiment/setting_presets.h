#pragma once

#include "evolution/fields/setting_field.h"
#include "evolution/kinds/evolution_kinds.h"
#include "evolution/settings/experiment_settings.h"

#include <span>
#include <string_view>

namespace cambrian {

// A named set of values for one table of settings and its sub-tables.
struct SettingPreset {
    std::string_view table;  // path of the table: "environment", "mutation", "trial"
    const char* label;
    const char* help;
    void (*apply)(ExperimentSettings& settings, const EvolutionKinds& kinds);
    bool of_plane = false;  // whether it is the same as another one in three dimensions
};

// Returns the presets; those of one table are adjacent.
std::span<const SettingPreset> setting_presets();
std::span<const SettingPreset> setting_presets(std::string_view table);

// Returns whether applying the preset would change no setting.
bool is_in_force(const SettingPreset& preset, const ExperimentSettings& settings,
                 const EvolutionKinds& kinds, const std::vector<SettingField>& fields);

}  // namespace cambrian
