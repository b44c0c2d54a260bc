#include "persist/rescoring.h"

#include "evolution/trials.h"

#include <memory>

namespace cambrian {

std::optional<std::string> other_simulator(const ScoredRecord& scored) {
    if (scored.simulator == kSimulatorVersion) return std::nullopt;
    return "scored by simulator " + scored.simulator + ", this is " +
           std::string(kSimulatorVersion);
}

EvaluationResult run_scored_trial(const CreatureDocument& document, const EvolutionKinds& kinds,
                                  const std::stop_token& stop) {
    CAMBRIAN_ASSERT(document.scored.has_value(), "only a scored creature has a trial to run");
    const ExperimentSettings settings = settings_of(*document.scored);
    const EvaluationRequest request{.genome = std::make_shared<const Genome>(document.genome),
                                    .trial_seed = trial_seed(settings)};
    return evaluate_in_trials(request, settings, kinds, stop);
}

Result<CreatureDocument> rescored(CreatureDocument document, const EvolutionKinds& kinds,
                                  const std::stop_token& stop) {
    if (!document.scored) return Error{"holds no score to replace"};
    const EvaluationResult result = run_scored_trial(document, kinds, stop);
    if (result.outcome == Outcome::kInterrupted) return Error{"interrupted"};
    if (result.outcome != Outcome::kCompleted) {
        return Error{"its trial is not finished by this simulator (" +
                     std::string(outcome_name(result.outcome)) + ", " + result.reason + ")"};
    }
    ScoredRecord& scored = *document.scored;
    scored.fitness = result.fitness;
    scored.unit = kinds.goals.find(scored.goal)->unit;
    scored.trajectory = result.digest;
    scored.simulator = kSimulatorVersion;
    scored.confirmed.reset();
    scored.ticks.clear();
    scored.finer = result.finer;
    complete_score(document, kinds, stop);
    if (stop.stop_requested()) return Error{"interrupted"};
    return document;
}

}  // namespace cambrian
