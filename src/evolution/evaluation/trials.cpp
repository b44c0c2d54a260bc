#include "evolution/evaluation/trials.h"

#include "core/hash.h"
#include "core/random.h"
#include "core/sample_statistics.h"
#include "creature/placement.h"
#include "evolution/settings/trial_work.h"
#include "math/angle.h"

#include <algorithm>
#include <utility>

namespace cambrian {
namespace {

constexpr double kAccurateTolerance = 1e-6;
constexpr double kAccurateContactStep = 0.25;  // times the contact step of the settings
constexpr double kAccurateWork = 100.0;  // most computing work, as a multiple of the usual trial's
constexpr int kHeldOutTrials = 8;
constexpr std::uint64_t kHeldOut =
    103;  // separates their random streams from those of all generations

JudgedTrial judge_jittered(const EvaluationRequest& request, const LightDraw& light,
                           const ExperimentSettings& settings, const EvolutionKinds& kinds,
                           const std::stop_token& stop) {
    const Jitter jitter = jitter_of(request.trial_seed, light.trial, settings.world.trial);
    ExperimentSettings changed = settings;
    changed.world.environment.friction *= jitter.friction_factor;
    changed.world.light = light;
    Genome tilted = *request.genome;
    turn_root(tilted, jitter.tilt, jitter.heading);
    EvaluationRequest other = request;
    other.genome = std::make_shared<const Genome>(std::move(tilted));
    return judge_trial(other, changed, kinds, stop);
}

// Adds the result of the next trial to that of all trials so far, but for the score.
void add_trial(EvaluationResult& all, const EvaluationResult& next) {
    Hash64 digest;
    digest.add(all.digest);
    digest.add(next.digest);
    all.digest = digest.value();
    all.computed_time += next.computed_time;
    all.work += next.work;
    if (next.outcome == Outcome::kCompleted) return;
    all.outcome = next.outcome;
    all.reason = "in a further trial: " + next.reason;
    all.fitness = next.fitness;  // the least
}

// Returns the score of several trials by a rule of kCombineIds.
double combined_score(const std::vector<double>& scores, std::string_view rule) {
    constexpr double kShareOfMean = 0.1;
    if (rule == "minimum") return *std::min_element(scores.begin(), scores.end());
    const double share = 1.0 / static_cast<double>(scores.size());
    double sum = 0.0;
    for (const double score : scores)
        sum += share * score;
    if (rule == "mean") return sum;
    return kShareOfMean * sum + (1.0 - kShareOfMean) * mean_of_worse_half(scores);
}

// Goals that judge all trials together get the score of all shares.
EvaluationResult judge_in_trials(const EvaluationRequest& request, std::uint64_t light_seed,
                                 const ExperimentSettings& settings, const EvolutionKinds& kinds,
                                 const std::stop_token& stop) {
    const TrialSettings& trials = settings.world.trial;
    ExperimentSettings first = settings;
    first.world.light = {light_seed, 0};
    JudgedTrial judged = judge_trial(request, first, kinds, stop);
    EvaluationResult& all = judged.result;
    if (trials.trials == 1 || all.outcome != Outcome::kCompleted) return all;
    std::vector<double> scores = {all.fitness};
    for (int trial = 1; trial < trials.trials && all.outcome == Outcome::kCompleted; ++trial) {
        const JudgedTrial next =
            judge_jittered(request, {light_seed, trial}, settings, kinds, stop);
        add_trial(all, next.result);
        scores.push_back(next.result.fitness);
        judged.shares.insert(judged.shares.end(), next.shares.begin(), next.shares.end());
    }
    if (all.outcome != Outcome::kCompleted) return all;
    const GoalKind& goal = *kinds.goals.find(settings.goal);
    all.fitness = goal.score_of_shares != nullptr && trials.combine != "minimum"
                      ? goal.score_of_shares(judged.shares)
                      : combined_score(scores, trials.combine);
    return all;
}

}  // namespace

std::uint64_t trial_seed(const ExperimentSettings& settings) {
    const auto draw = static_cast<std::uint64_t>(settings.world.trial.draw);
    return stream_seed(settings.seed, draw, 0, Purpose::kTrial);
}

Jitter jitter_of(std::uint64_t trial_seed, int trial, const TrialSettings& settings) {
    if (trial == 0) return {};
    RandomStream stream(stream_seed({trial_seed, static_cast<std::uint64_t>(trial)}));
    Jitter jitter;
    jitter.friction_factor = 1.0 + settings.friction_jitter * stream.uniform(-1.0, 1.0);
    jitter.tilt = to_radians(settings.tilt_jitter) * stream.uniform(-1.0, 1.0);
    jitter.heading = stream.uniform(-kPi, kPi);
    return jitter;
}

TrialWorld first_trial_world(const ExperimentSettings& settings) {
    TrialWorld world = settings.world;
    if (world.light == LightDraw{}) world.light.seed = trial_seed(settings);
    world.expression = settings.expression;
    return world;
}

TrialSetup trial_setup(const GenomePtr& genome, const ExperimentSettings& settings, int trial) {
    TrialSetup setup{genome, first_trial_world(settings)};
    setup.world.light.trial = trial;
    if (trial == 0) return setup;
    const Jitter jitter = jitter_of(setup.world.light.seed, trial, settings.world.trial);
    setup.world.environment.friction *= jitter.friction_factor;
    Genome turned = *genome;
    turn_root(turned, jitter.tilt, jitter.heading);
    setup.genome = std::make_shared<const Genome>(std::move(turned));
    return setup;
}

EvaluationResult evaluate_in_trials(const EvaluationRequest& request,
                                    const ExperimentSettings& settings, const EvolutionKinds& kinds,
                                    const std::stop_token& stop) {
    if (!request.probe) return judge_in_trials(request, request.trial_seed, settings, kinds, stop);
    EvaluationRequest probed = request;
    probed.probe.reset();
    Genome turned = *request.genome;
    const ExperimentSettings world = probed_world(*request.probe, settings, turned);
    probed.genome = std::make_shared<const Genome>(std::move(turned));
    return judge_in_trials(probed, request.probe->seed, world, kinds, stop);
}

EvaluationResult held_out_result(const GenomePtr& genome, const ExperimentSettings& settings,
                                 const EvolutionKinds& kinds, const std::stop_token& stop,
                                 std::vector<Lesion> lesions) {
    ExperimentSettings held_out = settings;
    held_out.world.trial.draw = 0;
    held_out.world.trial.trials = kHeldOutTrials;
    const std::uint64_t seed = stream_seed({trial_seed(held_out), kHeldOut});
    return evaluate_in_trials({.genome = genome, .trial_seed = seed, .lesions = std::move(lesions)},
                              held_out, kinds, stop);
}

double held_out_score(const GenomePtr& genome, const ExperimentSettings& settings,
                      const EvolutionKinds& kinds, const std::stop_token& stop,
                      std::vector<Lesion> lesions) {
    return held_out_result(genome, settings, kinds, stop, std::move(lesions)).fitness;
}

ExperimentSettings accurate_settings(const ExperimentSettings& settings,
                                     const EvolutionKinds& kinds) {
    ExperimentSettings accurate = settings;
    SceneSettings& scene = accurate.world.scene;
    scene.integrator = kinds.creature.scene.accurate_integrator;
    scene.tolerance = std::min(scene.tolerance, kAccurateTolerance);
    scene.contact_step = std::max(kAccurateContactStep * scene.contact_step, kLeastContactStep);
    scene.max_evaluations = std::min({kAccurateWork * scene.max_evaluations, kMostEvaluations,
                                      most_evaluations(accurate.world.trial)});
    return accurate;
}

std::vector<double> scores_in(std::span<const Probe> probes, const GenomePtr& genome,
                              const ExperimentSettings& settings, const EvolutionKinds& kinds,
                              const std::stop_token& stop) {
    std::vector<double> scores;
    for (const Probe& probe : probes) {
        if (stop.stop_requested()) break;
        const EvaluationResult result = evaluate_in_trials(
            {.genome = genome, .trial_seed = trial_seed(settings), .probe = probe}, settings, kinds,
            stop);
        scores.push_back(result.fitness);
    }
    return scores;
}

}  // namespace cambrian
