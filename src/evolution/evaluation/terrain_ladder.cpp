#include "evolution/evaluation/terrain_ladder.h"

#include "evolution/evaluation/trials.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace cambrian {
namespace {

constexpr double kLowestRung = 0.2;    // level with which scores are compared
constexpr double kKeptToClimb = 0.6;   // share of the score there
constexpr double kRungsPerLevel = 20;  // levels are whole multiples of 0.05

const TerrainSettings& ladder_of(const ExperimentSettings& settings) {
    return settings.world.environment.terrain;
}

}  // namespace

bool climbs_ladder(const ExperimentSettings& settings) {
    const TerrainSettings& terrain = ladder_of(settings);
    return terrain.ladder && terrain.level < 1.0 && !terrain.is_flat() && terrain.kind != "drawn";
}

IndividualPtr median_survivor(std::span<const IndividualPtr> population, std::uint32_t generation) {
    std::vector<IndividualPtr> survivors;
    for (const IndividualPtr& one : population) {
        if (one->evaluated && one->born < generation && one->result.outcome == Outcome::kCompleted)
            survivors.push_back(one);
    }
    if (survivors.empty()) return nullptr;
    std::sort(survivors.begin(), survivors.end(),
              [](const IndividualPtr& a, const IndividualPtr& b) { return better(*a, *b); });
    return survivors[survivors.size() / 2];
}

std::optional<bool> is_ready_to_climb(const Individual& one, const ExperimentSettings& settings,
                                      EvaluationBackend& backend, const std::stop_token& stop) {
    ExperimentSettings lowest = settings;
    lowest.world.environment.terrain.level = kLowestRung;
    const EvaluationRequest request{.genome = one.genome, .trial_seed = trial_seed(lowest)};
    std::optional<EvaluationResult> there;
    EvaluationProgress progress;  // not that of the generation
    if (!backend.evaluate(std::span(&request, 1), std::span(&there, 1), lowest, progress, stop))
        return std::nullopt;
    const double here = unconfirmed_score(one.result);
    return here > 0.0 && here >= kKeptToClimb * there->fitness;
}

SettingsPtr on_next_level(const ExperimentSettings& settings) {
    ExperimentSettings next = settings;
    double& level = next.world.environment.terrain.level;
    level = std::min(1.0, (std::floor(level * kRungsPerLevel + 0.5) + 1.0) / kRungsPerLevel);
    return std::make_shared<const ExperimentSettings>(std::move(next));
}

bool changed_by_run(const ExperimentSettings& before, const ExperimentSettings& after) {
    return before.world.trial.draw != after.world.trial.draw ||
           (ladder_of(after).ladder && ladder_of(before).level != ladder_of(after).level);
}

}  // namespace cambrian
