#pragma once

// The part of an experiment's settings that a result depends on, as workers get it.

#include "core/result.h"
#include "evolution/kinds/evolution_kinds.h"
#include "evolution/settings/experiment_settings.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace cambrian {

struct JudgingSettings {
    std::string text;       // a settings file; everything else in it is at its default
    std::uint64_t key = 0;  // hash of the text
};

// Whether results of trials and of probes are the same under both.
bool judge_alike(const ExperimentSettings& a, const ExperimentSettings& b);

std::uint64_t settings_key(std::string_view text);

// Fails if the text would not read back to settings that judge the same.
Result<JudgingSettings> judging_settings(const ExperimentSettings& settings,
                                         const EvolutionKinds& kinds);

}  // namespace cambrian
