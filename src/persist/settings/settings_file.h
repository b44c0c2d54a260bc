#pragma once

// Settings files, *.toml: every setting of an experiment as a person edits it, each with its unit,
// range, default and help beside it. Which settings there are is said by setting_fields() alone.

#include "core/result.h"
#include "evolution/kinds/evolution_kinds.h"
#include "evolution/settings/experiment_settings.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace cambrian {

// The settings of a file that says no more than the goal (an id, or empty for the usual one): the
// world is the one the goal makes sense in.
ExperimentSettings default_settings(std::string_view goal, const EvolutionKinds& kinds);

// Keys left out have their defaults, so an empty file is a valid experiment. Unknown keys, wrong
// types and values out of range are errors; the message names the file, the line, the key and what
// was expected, one line for each. What is loaded passes check_settings.
Result<ExperimentSettings> load_settings(const std::filesystem::path& path,
                                         const EvolutionKinds& kinds);
Status save_settings(const std::filesystem::path& path, const ExperimentSettings& settings,
                     const EvolutionKinds& kinds);

// The same for text; source names it in messages.
Result<ExperimentSettings> parse_settings(std::string_view text, std::string_view source,
                                          const EvolutionKinds& kinds);

// Settings in several texts, each of which says some of them: a later one replaces what an earlier
// one says. A key that none has is at its default, which may go with the goal.
struct SettingsText {
    std::string text;
    std::string source;  // names it in messages
};
Result<ExperimentSettings> merge_settings(const std::vector<SettingsText>& texts,
                                          const EvolutionKinds& kinds);
Result<SettingsText> read_settings_text(const std::filesystem::path& path);

std::string write_settings(const ExperimentSettings& settings, const EvolutionKinds& kinds);

}  // namespace cambrian
