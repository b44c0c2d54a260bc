#pragma once

// A person's choice of what to compare.

#include "comparison/plan.h"
#include "evolution/fields/setting_field.h"

#include <string>
#include <vector>

namespace cambrian {

struct ComparisonDraft {
    static constexpr int kFewestTrials = 100;
    static constexpr int kMostTrials = 1'000'000;
    static constexpr int kMostSeeds = 50;

    std::string varied;  // setting, as in "selection.method"; empty for none
    std::string values;  // of that setting, separated by commas; the first is the reference
    bool random_search = true;
    int seeds = 5;      // runs of each arm, with the seeds from 1 on
    int trials = 3000;  // of each run

    friend bool operator==(const ComparisonDraft&, const ComparisonDraft&) = default;
};

// Returns whether arms in one world may differ in the setting.
bool may_vary(const SettingField& field);
// Returns a few values to begin with, the present one first: "truncation, rank".
std::string suggested_values(const SettingField& field, const ExperimentSettings& settings);

// Returns the plan, in the world of the settings. Fails if the values are no values of the setting.
Result<ComparisonPlan> plan_of(const ComparisonDraft& draft, const ExperimentSettings& settings,
                               const EvolutionKinds& kinds);

}  // namespace cambrian
