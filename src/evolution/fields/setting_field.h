#pragma once

// The one description of every setting: where it is stored, its name in files, its label, unit,
// range and help. Settings files, the studio's controls and the documentation all read this table.

#include "core/result.h"
#include "evolution/kinds/evolution_kinds.h"
#include "evolution/settings/experiment_settings.h"

#include <cstdint>
#include <functional>
#include <string>
#include <variant>
#include <vector>

namespace cambrian {

// A place inside an ExperimentSettings.
using SettingRef = std::variant<bool*, int*, std::uint64_t*, double*, std::string*>;

struct SettingField {
    std::string table;  // "environment"
    std::string key;    // "gravity"
    std::string label;  // "Gravity"
    std::string unit;   // "m/s^2", or empty
    std::string help;   // one sentence: what it does
    double low = 0.0;   // range of numbers, ends included
    double high = 0.0;
    std::vector<std::string> choices;  // allowed texts, for text settings
    bool logarithmic = false;          // better dragged on a logarithmic scale
    // May change while an experiment runs; takes effect from the next generation. Otherwise it
    // defines the run and a change starts a new one.
    bool live = true;
    // Whether it makes a difference under the other settings; empty: always.
    std::function<bool(const ExperimentSettings&)> applies;
    std::function<SettingRef(ExperimentSettings&)> at;
};

// All settings, grouped by table, in the order shown and written.
std::vector<SettingField> setting_fields(const EvolutionKinds& kinds);

// The first setting outside its range or contradicting another, as "[table] key: ..."; success if
// none.
Status check_settings(const ExperimentSettings& settings, const EvolutionKinds& kinds);

// What is allowed but makes little sense, a sentence each.
std::vector<std::string> setting_warnings(const ExperimentSettings& settings,
                                          const EvolutionKinds& kinds);

}  // namespace cambrian
