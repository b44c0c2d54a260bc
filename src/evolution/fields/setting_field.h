#pragma once

// The one description of every setting: where it is stored, its name in files, its label, unit,
// range and help. Settings files, the studio's controls and the documentation all read this table.

#include "core/result.h"
#include "evolution/kinds/evolution_kinds.h"
#include "evolution/settings/setting_builder.h"

#include <string>
#include <vector>

namespace cambrian {

// All settings, grouped by table, in the order shown and written. The kinds must outlive them.
std::vector<SettingField> setting_fields(const EvolutionKinds& kinds);

// The first setting outside its range or contradicting another, as "[table] key: ..."; success if
// none.
Status check_settings(const ExperimentSettings& settings, const EvolutionKinds& kinds);

// What is allowed but makes little sense, a sentence each.
std::vector<std::string> setting_warnings(const ExperimentSettings& settings,
                                          const EvolutionKinds& kinds);

}  // namespace cambrian
