#pragma once

// The part of an experiment's settings on which results depend, in the form that workers get.

#include "core/result.h"
#include "evolution/kinds/evolution_kinds.h"
#include "evolution/settings/experiment_settings.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace cambrian {

// A settings file in which all other settings have their default and, for a contest, a creature
// file for each opponent, each after a line that says so.
struct JudgingSettings {
    std::string text;
    std::uint64_t key = 0;  // hash of the text
};

// Returns whether results of trials and of probes are the same with both.
bool judge_alike(const ExperimentSettings& a, const ExperimentSettings& b);

std::uint64_t settings_key(std::string_view text);

// Fails if reading the text would not give settings with the same results, or if it is larger than
// kMostSettingsBytes.
Result<JudgingSettings> judging_settings(const ExperimentSettings& settings,
                                         const EvolutionKinds& kinds);

// Has them made again only for settings with which results differ.
class KeptJudgingSettings {
public:
    const Result<JudgingSettings>& of(const ExperimentSettings& settings,
                                      const EvolutionKinds& kinds) {
        if (!judged_ || !judge_alike(*judged_, settings)) {
            judged_ = settings;
            made_ = judging_settings(settings, kinds);
        }
        return made_;
    }

private:
    std::optional<ExperimentSettings> judged_;
    Result<JudgingSettings> made_ = Error{};
};

// Reads the text; `source` names it in messages.
Result<ExperimentSettings> read_judging_settings(std::string_view text, std::string_view source,
                                                 const EvolutionKinds& kinds);

}  // namespace cambrian
