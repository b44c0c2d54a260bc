#pragma once

// The table of all settings: where each is stored, its name in files, its label, unit, range and
// help. Settings files, the studio's controls and the documentation all read this table.

#include "core/result.h"
#include "evolution/kinds/evolution_kinds.h"
#include "evolution/settings/experiment_settings.h"

#include <cstdint>
#include <functional>
#include <string>
#include <variant>
#include <vector>

namespace cambrian {

// A pointer to a member of an ExperimentSettings.
using SettingRef = std::variant<bool*, int*, std::uint64_t*, double*, std::string*>;

struct SettingField {
    std::string table;  // "environment"
    std::string key;    // "gravity"
    std::string label;  // "Gravity"
    std::string unit;   // "m/s^2", or empty
    std::string help;   // one sentence
    double low = 0.0;   // range of numbers, both ends included
    double high = 0.0;
    std::vector<std::string> choices;  // allowed values of a text
    bool logarithmic = false;          // whether a slider should be logarithmic
    // Whether it may change during a run, from the next generation on. Otherwise it defines the run
    // and a change starts a new one.
    bool live = true;
    // Returns whether the setting has an effect under the other settings; null means always.
    std::function<bool(const ExperimentSettings&)> applies;
    std::function<SettingRef(ExperimentSettings&)> at;
};

// Returns all settings, grouped by table, in the order in which they are displayed and written.
std::vector<SettingField> setting_fields(const EvolutionKinds& kinds);

// Returns an error for the first setting that is out of range or contradicts another, as "[table]
// key: ...".
Status check_settings(const ExperimentSettings& settings, const EvolutionKinds& kinds);

// Returns a sentence for each setting that is allowed but makes little sense.
std::vector<std::string> setting_warnings(const ExperimentSettings& settings,
                                          const EvolutionKinds& kinds);

}  // namespace cambrian
