#include "studio/coach/rivals.h"

#include "core/sample_statistics.h"
#include "evolution/evaluation/trials.h"
#include "pictures/motion/recorded_motion.h"
#include "studio/files/sample_library.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace cambrian {
namespace {

// Returns the score as a generation's survivors have theirs; nothing if the trial fails.
std::optional<double> score_under(const ExperimentSettings& settings, const GenomePtr& genome,
                                  const EvolutionKinds& kinds, const std::stop_token& stop) {
    const EvaluationRequest request{.genome = genome, .trial_seed = trial_seed(settings)};
    const EvaluationResult result = evaluate_in_trials(request, settings, kinds, stop);
    if (result.outcome != Outcome::kCompleted) return std::nullopt;
    std::vector<double> scores = scores_in(probes_of(settings, 0, settings.selection.confirmations),
                                           genome, settings, kinds, stop);
    scores.push_back(result.fitness);
    return median(std::move(scores));
}

double travel_of(const ExperimentSettings& settings, const Genome& genome, const Kinds& kinds) {
    auto phenotype = std::make_shared<const Phenotype>(
        express(genome, kinds, settings.expression, settings.world.scene));
    const auto trial = record_trial(std::move(phenotype), kinds, first_trial_world(settings));
    if (!trial || trial->record.samples.empty()) return 0.0;
    return trial->record.samples.back().center_of_mass.x() -
           trial->record.samples.front().center_of_mass.x();
}

std::optional<JudgedRival> judged_rival(const Sample& sample, const ExperimentSettings& settings,
                                        const EvolutionKinds& kinds, const std::stop_token& stop) {
    JudgedIndividual creature = sample.creature;
    if (sample.phenotype == nullptr || !creature.individual->evaluated) return std::nullopt;
    const ExperimentSettings& its = *creature.settings;
    if (its.goal != settings.goal || !(its.world.environment == settings.world.environment))
        return std::nullopt;
    ExperimentSettings here = settings;
    here.expression = its.expression;
    const GenomePtr& genome = creature.individual->genome;
    const std::optional<double> score = score_under(here, genome, kinds, stop);
    if (!score || *score <= 0.0) return std::nullopt;  // it would be beaten by standing still
    const double travel = travel_of(here, *genome, kinds.creature);
    creature.settings = std::make_shared<const ExperimentSettings>(std::move(here));
    return JudgedRival{sample.title, std::move(creature), *score, travel};
}

}  // namespace

std::vector<JudgedRival> judge_rivals(const std::filesystem::path& folder,
                                      const ExperimentSettings& settings,
                                      const EvolutionKinds& kinds, const std::stop_token& stop) {
    std::vector<JudgedRival> rivals;
    for (const Sample& sample : read_samples(folder, kinds)) {
        if (stop.stop_requested()) return {};
        if (auto rival = judged_rival(sample, settings, kinds, stop))
            rivals.push_back(std::move(*rival));
    }
    if (stop.stop_requested()) return {};
    std::stable_sort(rivals.begin(), rivals.end(),
                     [](const JudgedRival& a, const JudgedRival& b) { return a.score < b.score; });
    return rivals;
}

}  // namespace cambrian
