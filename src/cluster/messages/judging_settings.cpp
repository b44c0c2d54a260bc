#include "cluster/messages/judging_settings.h"

#include "core/hash.h"
#include "persist/settings/settings_file.h"

#include <fmt/core.h>

namespace cambrian {
namespace {

constexpr const char* kSource = "settings of a run";

ExperimentSettings judging_part(const ExperimentSettings& settings, const EvolutionKinds& kinds) {
    ExperimentSettings part = default_settings(settings.goal, kinds);
    part.world = settings.world;
    part.expression = settings.expression;
    // Affects the probes' worlds.
    part.selection.confirm_jitter = settings.selection.confirm_jitter;
    return part;
}

}  // namespace

bool judge_alike(const ExperimentSettings& a, const ExperimentSettings& b) {
    return same_judgement(a, b) && a.selection.confirm_jitter == b.selection.confirm_jitter;
}

std::uint64_t settings_key(std::string_view text) {
    Hash64 hash;
    hash.add(text);
    return hash.value();
}

Result<JudgingSettings> judging_settings(const ExperimentSettings& settings,
                                         const EvolutionKinds& kinds) {
    if (kinds.goals.find(settings.goal)->is_contest)
        return Error{fmt::format(
            "goal \"{}\" is evaluated on this machine only: opponents do not travel; start without "
            "--cluster",
            settings.goal)};
    const ExperimentSettings part = judging_part(settings, kinds);
    JudgingSettings judging;
    judging.text = write_settings(part, kinds);
    judging.key = settings_key(judging.text);
    const Result<ExperimentSettings> read = parse_settings(judging.text, kSource, kinds);
    if (!read) return read.error();
    if (!judge_alike(*read, part))
        return Error{std::string(kSource) + ": no settings file can hold them"};
    return judging;
}

}  // namespace cambrian
