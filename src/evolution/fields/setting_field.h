#pragma once

// The table of all settings: where each is stored, its name in files, its label, unit, range and
// help. Settings files, the studio's controls and the documentation all read this table.

#include "core/result.h"
#include "evolution/kinds/evolution_kinds.h"
#include "evolution/settings/setting_builder.h"

#include <string>
#include <vector>

namespace cambrian {

// Returns all settings, grouped by table, in the order in which they are displayed and written. The
// kinds must outlive them.
std::vector<SettingField> setting_fields(const EvolutionKinds& kinds);

// Returns "selection.method".
std::string path_of(const SettingField& field);

// Returns an error for the first setting that is out of range or contradicts another, as "[table]
// key: ...".
Status check_settings(const ExperimentSettings& settings, const EvolutionKinds& kinds);

// Return the same for a preserve: the settings that a preserve has, those that a file may leave
// out, and an error for the first one that is not allowed. The defaults of a world with ground are
// those of land, others are those of water.
std::vector<SettingField> preserve_fields(const EvolutionKinds& kinds);
ExperimentSettings preserve_defaults(const EvolutionKinds& kinds, bool has_ground = false);
Status check_preserve(const ExperimentSettings& settings, const EvolutionKinds& kinds);

// Bytes that a preserve may need; its snapshots then have at most the 128 MB that files hold.
inline constexpr double kMostPreserveMemory = 700e6;
// Returns about how many bytes a preserve needs when all of its energy is plants.
double preserve_memory(const PreserveSettings& laws);
Status check_preserve_memory(const PreserveSettings& laws);

// Returns a sentence for each setting that is allowed but makes little sense.
std::vector<std::string> setting_warnings(const ExperimentSettings& settings,
                                          const EvolutionKinds& kinds);

}  // namespace cambrian
