#pragma once

// Evaluation of a creature in several slightly different trials (simulator/README.md 1).

#include "evolution/evaluation/evaluation.h"

#include <span>
#include <vector>

namespace cambrian {

// Returns the seed of chance in all trials of an experiment: jitter and the places of a light. It
// is the same for all creatures until it is renewed, so their scores can be compared.
std::uint64_t trial_seed(const ExperimentSettings& settings);

// Returns the world of the first trial, with its random draw. A replay shows this trial.
TrialWorld first_trial_world(const ExperimentSettings& settings);

// A creature and its world as one of the settings' trials judges them.
struct TrialSetup {
    GenomePtr genome;
    TrialWorld world;
};
// `trial` counts from 0; the settings have at least one more.
TrialSetup trial_setup(const GenomePtr& genome, const ExperimentSettings& settings, int trial);

// The change of world and creature in a trial; trial 0 has none.
struct Jitter {
    double friction_factor = 1.0;
    double tilt = 0.0;     // rad, added to the start pose
    double heading = 0.0;  // rad, by which a creature in space is turned about the vertical first

    friend bool operator==(const Jitter&, const Jitter&) = default;
};
Jitter jitter_of(std::uint64_t trial_seed, int trial, const TrialSettings& settings);

// Calls evaluate() for each of the settings' trials. The score is their mean or minimum; if one
// fails, the evaluation fails. Goals may judge all trials together instead of taking their mean.
// A request's probe changes the world of all trials and the places of the light. Descriptions of
// body and motion belong to the first trial; the digest covers all.
EvaluationResult evaluate_in_trials(const EvaluationRequest& request,
                                    const ExperimentSettings& settings, const EvolutionKinds& kinds,
                                    const std::stop_token& stop = {});

// Return the result, or its score, of eight trials whose light, wall and other chance no generation
// draws; the score is the least of the goal if one fails.
EvaluationResult held_out_result(const GenomePtr& genome, const ExperimentSettings& settings,
                                 const EvolutionKinds& kinds, const std::stop_token& stop = {},
                                 std::vector<Lesion> lesions = {});
double held_out_score(const GenomePtr& genome, const ExperimentSettings& settings,
                      const EvolutionKinds& kinds, const std::stop_token& stop = {},
                      std::vector<Lesion> lesions = {});

// Returns the settings with an accurate integrator, a tolerance of 1e-6, a quarter of the contact
// step and a hundred times the work, as far as settings may have these values.
ExperimentSettings accurate_settings(const ExperimentSettings& settings,
                                     const EvolutionKinds& kinds);

// The creature's score in each probe's world; the least of the goal for a trial that fails. After a
// stop request there are fewer.
std::vector<double> scores_in(std::span<const Probe> probes, const GenomePtr& genome,
                              const ExperimentSettings& settings, const EvolutionKinds& kinds,
                              const std::stop_token& stop = {});

}  // namespace cambrian
