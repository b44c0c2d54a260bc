#include "evolution/evaluation/trials.h"

#include "core/hash.h"
#include "core/random.h"
#include "math/angle.h"

#include <algorithm>
#include <utility>

namespace cambrian {
namespace {

EvaluationResult evaluate_jittered(const EvaluationRequest& request, const Jitter& jitter,
                                   const ExperimentSettings& settings, const EvolutionKinds& kinds,
                                   const std::stop_token& stop) {
    ExperimentSettings changed = settings;
    changed.world.environment.friction *= jitter.friction_factor;
    Genome tilted = *request.genome;
    tilted.root_angle = wrap_angle(tilted.root_angle + jitter.tilt);
    EvaluationRequest other = request;
    other.genome = std::make_shared<const Genome>(std::move(tilted));
    return evaluate(other, changed, kinds, stop);
}

// Combines the result of all trials so far with that of the next one.
void combine(EvaluationResult& all, const EvaluationResult& next, bool minimum, double share) {
    Hash64 digest;
    digest.add(all.digest);
    digest.add(next.digest);
    all.digest = digest.value();
    all.computed_time += next.computed_time;
    all.work += next.work;
    if (next.outcome != Outcome::kCompleted) {
        all.outcome = next.outcome;
        all.reason = "in a further trial: " + next.reason;
        all.fitness = 0.0;
        return;
    }
    all.fitness =
        minimum ? std::min(all.fitness, next.fitness) : all.fitness + share * next.fitness;
}

}  // namespace

std::uint64_t trial_seed(const ExperimentSettings& settings) {
    return stream_seed(settings.seed, 0, 0, Purpose::kTrial);
}

Jitter jitter_of(std::uint64_t trial_seed, int trial, const TrialSettings& settings) {
    if (trial == 0) return {};
    RandomStream stream(stream_seed({trial_seed, static_cast<std::uint64_t>(trial)}));
    Jitter jitter;
    jitter.friction_factor = 1.0 + settings.friction_jitter * stream.uniform(-1.0, 1.0);
    jitter.tilt = to_radians(settings.tilt_jitter) * stream.uniform(-1.0, 1.0);
    return jitter;
}

EvaluationResult evaluate_in_trials(const EvaluationRequest& request,
                                    const ExperimentSettings& settings, const EvolutionKinds& kinds,
                                    const std::stop_token& stop) {
    if (request.probe) {
        EvaluationRequest probed = request;
        probed.probe.reset();
        Genome turned = *request.genome;
        const ExperimentSettings world = probed_world(*request.probe, settings, turned);
        probed.genome = std::make_shared<const Genome>(std::move(turned));
        return evaluate_in_trials(probed, world, kinds, stop);
    }
    const TrialSettings& trials = settings.world.trial;
    EvaluationResult all = evaluate(request, settings, kinds, stop);
    if (trials.trials == 1 || all.outcome != Outcome::kCompleted) return all;
    const bool minimum = trials.combine == "minimum";
    const double share = 1.0 / trials.trials;
    if (!minimum) all.fitness *= share;
    for (int trial = 1; trial < trials.trials && all.outcome == Outcome::kCompleted; ++trial) {
        const Jitter jitter = jitter_of(request.trial_seed, trial, trials);
        combine(all, evaluate_jittered(request, jitter, settings, kinds, stop), minimum, share);
    }
    return all;
}

std::vector<double> scores_in(std::span<const Probe> probes, const GenomePtr& genome,
                              const ExperimentSettings& settings, const EvolutionKinds& kinds,
                              const std::stop_token& stop) {
    std::vector<double> scores;
    for (const Probe& probe : probes) {
        const EvaluationResult result = evaluate_in_trials(
            {.genome = genome, .trial_seed = trial_seed(settings), .probe = probe}, settings, kinds,
            stop);
        scores.push_back(result.outcome == Outcome::kCompleted ? result.fitness : 0.0);
    }
    return scores;
}

}  // namespace cambrian
