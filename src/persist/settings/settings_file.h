#pragma once

// Settings files, *.toml: every setting of an experiment for people to edit, each with its unit,
// range, default and help. setting_fields() is the only list of settings.

#include "core/result.h"
#include "evolution/kinds/evolution_kinds.h"
#include "evolution/settings/experiment_settings.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace cambrian {

// A settings file describes one of these, which decides its tables.
enum class SettingsUse : std::uint8_t { kExperiment, kPreserve };

// Returns what a text describes: a preserve if it has the table [preserve].
SettingsUse use_of_settings(std::string_view text);

// Returns how many dimensions the world of settings has: 3 if they say so, otherwise 2.
int dimensions_of_settings(std::string_view text);

// Returns the settings of a file that has only the goal (an id, or empty for the default). Their
// world is the goal's default.
ExperimentSettings default_settings(std::string_view goal, const EvolutionKinds& kinds);

// Missing keys have their defaults, so an empty file is a valid experiment. Unknown keys, wrong
// types and values out of range are errors. The message has one line for each, with file, line, key
// and the expected value. Loaded settings pass check_settings.
Result<ExperimentSettings> load_settings(const std::filesystem::path& path,
                                         const EvolutionKinds& kinds,
                                         SettingsUse use = SettingsUse::kExperiment);
Status save_settings(const std::filesystem::path& path, const ExperimentSettings& settings,
                     const EvolutionKinds& kinds);

// Does the same for text; `source` names it in messages.
Result<ExperimentSettings> parse_settings(std::string_view text, std::string_view source,
                                          const EvolutionKinds& kinds,
                                          SettingsUse use = SettingsUse::kExperiment);

// Merges the settings of several texts; a later text replaces values of an earlier one. A key that
// no text has gets its default, which may depend on the goal.
struct SettingsText {
    std::string text;
    std::string source;  // name of the text in messages
};
Result<ExperimentSettings> merge_settings(const std::vector<SettingsText>& texts,
                                          const EvolutionKinds& kinds,
                                          SettingsUse use = SettingsUse::kExperiment);
Result<SettingsText> read_settings_text(const std::filesystem::path& path);

std::string write_settings(const ExperimentSettings& settings, const EvolutionKinds& kinds,
                           SettingsUse use = SettingsUse::kExperiment);
// All values for digests, without words and without younger settings that are at their default
// (SettingField::later).
std::string digested_settings(const ExperimentSettings& settings, const EvolutionKinds& kinds);

}  // namespace cambrian
