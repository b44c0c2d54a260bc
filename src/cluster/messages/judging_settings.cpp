#include "cluster/messages/judging_settings.h"

#include "cluster/messages/work_queue.h"
#include "core/hash.h"
#include "evolution/individual/judged_individual.h"
#include "persist/creature/creature_file.h"
#include "persist/creature/creature_format.h"
#include "persist/settings/settings_file.h"

#include <fmt/core.h>

namespace cambrian {
namespace {

constexpr const char* kSource = "settings of a run";
constexpr std::string_view kOpponent = "\n# opponent:\n";  // no line of a settings file

ExperimentSettings judging_part(const ExperimentSettings& settings, const EvolutionKinds& kinds) {
    ExperimentSettings part = default_settings(settings.goal, kinds);
    part.world = settings.world;
    part.expression = settings.expression;
    // Affects the probes' worlds.
    part.selection.confirm_jitter = settings.selection.confirm_jitter;
    part.selection.confirm_tilt = settings.selection.confirm_tilt;
    return part;
}

std::string text_of(const ExperimentSettings& part, const EvolutionKinds& kinds) {
    std::string text = write_settings(part, kinds);
    for (const GenomePtr& opponent : part.world.opponents.genomes) {
        text.append(kOpponent);
        text.append(write_creature({.creature = unjudged(opponent)}, kinds));
    }
    return text;
}

// Returns the text before the next opponent and removes it, and the line after it, from `rest`.
std::string_view next_part(std::string_view& rest) {
    const std::size_t end = rest.find(kOpponent);
    const std::string_view part = rest.substr(0, end);
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + kOpponent.size());
    return part;
}

}  // namespace

bool judge_alike(const ExperimentSettings& a, const ExperimentSettings& b) {
    return same_judgement(a, b) && a.selection.confirm_jitter == b.selection.confirm_jitter &&
           a.selection.confirm_tilt == b.selection.confirm_tilt;
}

std::uint64_t settings_key(std::string_view text) {
    Hash64 hash;
    hash.add(text);
    return hash.value();
}

Result<JudgingSettings> judging_settings(const ExperimentSettings& settings,
                                         const EvolutionKinds& kinds) {
    const ExperimentSettings part = judging_part(settings, kinds);
    JudgingSettings judging;
    judging.text = text_of(part, kinds);
    judging.key = settings_key(judging.text);
    if (judging.text.size() > kMostSettingsBytes)
        return Error{fmt::format("{}: {} bytes with the opponents, at most {} can be sent", kSource,
                                 judging.text.size(), kMostSettingsBytes)};
    const Result<ExperimentSettings> read = read_judging_settings(judging.text, kSource, kinds);
    if (!read) return read.error();
    if (!judge_alike(*read, part))
        return Error{std::string(kSource) + ": no settings file can hold them"};
    return judging;
}

Result<ExperimentSettings> read_judging_settings(std::string_view text, std::string_view source,
                                                 const EvolutionKinds& kinds) {
    if (text.size() > kMostSettingsBytes) return Error{fmt::format("{}: too large", source)};
    Result<ExperimentSettings> settings = parse_settings(next_part(text), source, kinds);
    if (!settings) return settings;
    auto& opponents = settings->world.opponents.genomes;
    while (!text.empty()) {
        if (opponents.size() == creature_format::kMostOpponents)
            return Error{
                fmt::format("{}: more than {} opponents", source, creature_format::kMostOpponents)};
        const Result<CreatureDocument> opponent = parse_creature(next_part(text), source, kinds);
        if (!opponent) return opponent.error();
        opponents.push_back(opponent->creature.individual->genome);
    }
    return settings;
}

}  // namespace cambrian
