#include "persist/creature/pruned_twin.h"

#include "evolution/evaluation/trials.h"

#include <utility>

namespace cambrian {

Result<CreatureDocument> pruned_twin(GenomePtr genome, const CreatureDocument& original,
                                     const ExperimentSettings& settings,
                                     const EvolutionKinds& kinds, const std::stop_token& stop) {
    const EvaluationResult result = evaluate_in_trials(
        {.genome = genome, .trial_seed = trial_seed(settings)}, settings, kinds, stop);
    if (result.outcome != Outcome::kCompleted)
        return Error{stop.stop_requested()
                         ? "interrupted; nothing was written"
                         : "the pruned creature does not finish: " + result.reason};
    JudgedIndividual twin =
        unjudged(std::move(genome), std::make_shared<const ExperimentSettings>(settings), "pruned");
    twin.generation = original.creature.generation;
    change_individual(twin, [&](Individual& each) {
        each.parents[0] = original.creature.individual->uid;
        each.evaluated = true;
        each.result = result;
    });
    CreatureDocument document = creature_document(std::move(twin), kinds);
    complete_score(document, kinds, stop);
    if (stop.stop_requested()) return Error{"interrupted; nothing was written"};
    return document;
}

}  // namespace cambrian
