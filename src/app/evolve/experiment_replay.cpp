#include "app/evolve/experiment_replay.h"

#include "evolution/individual/population_digest.h"

namespace cambrian {

ReplayOutcome replay_experiment(const SavedExperiment& saved, const EvolutionKinds& kinds,
                                EvaluationBackend& backend, const TrialWatch& watch) {
    ReplayOutcome outcome;
    Evolution evolution = begun_anew(saved, kinds);
    EvaluationProgress progress;
    for (const std::uint64_t digest : saved.digests) {
        if (outcome.generations > 0) {
            evolution.breed();
            give_commands(evolution, saved.journal);
        }
        if (!evolution.evaluate(backend, progress, watch.stop)) {
            outcome.stopped = true;
            return outcome;
        }
        if (population_digest(evolution.population()) != digest) {
            outcome.different = evolution.generation();
            return outcome;
        }
        ++outcome.generations;
        watch.note(outcome.generations);
    }
    return outcome;
}

}  // namespace cambrian
