// Several trials with jitter (simulator/README.md 1).
#include "evolution/evaluation/trials.h"

#include "core/hash.h"
#include "simulator/trial.h"
#include "support/catch.h"
#include "support/creatures.h"
#include "support/kinds.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

using namespace cambrian;
using test::kinds;

namespace {

ExperimentSettings robust(int trials, const char* combine) {
    ExperimentSettings settings;
    settings.world.trial.duration = 4.0;
    settings.world.trial.trials = trials;
    settings.world.trial.friction_jitter = 0.15;
    settings.world.trial.tilt_jitter = 2.0;
    settings.world.trial.combine = combine;
    return settings;
}

EvaluationResult judge(const ExperimentSettings& settings) {
    return evaluate_in_trials(
        {.genome = test::crawler(kinds().creature.catalog), .trial_seed = trial_seed(settings)},
        settings, kinds());
}

// Returns the score of each trial, computed one by one.
std::vector<double> scores(const ExperimentSettings& settings) {
    std::vector<double> all;
    for (int trial = 0; trial < settings.world.trial.trials; ++trial) {
        const Jitter jitter = jitter_of(trial_seed(settings), trial, settings.world.trial);
        Genome genome = *test::crawler(kinds().creature.catalog);
        genome.root_angle += jitter.tilt;
        ExperimentSettings world = settings;
        world.world.environment.friction *= jitter.friction_factor;
        all.push_back(
            evaluate({.genome = std::make_shared<const Genome>(genome)}, world, kinds()).fitness);
    }
    return all;
}

}  // namespace

TEST_CASE("the first trial is in the world as it is, others within the jitter",
          "[evolution][trials]") {
    const TrialSettings settings = robust(50, "mean").world.trial;
    CHECK(jitter_of(7, 0, settings) == Jitter{});
    std::set<double> frictions;
    double widest = 0.0;
    for (int trial = 1; trial < 50; ++trial) {
        const Jitter jitter = jitter_of(7, trial, settings);
        CHECK(std::abs(jitter.friction_factor - 1.0) <= 0.15);
        CHECK(std::abs(jitter.tilt) <= 2.0 * 3.14159265358979 / 180.0);
        widest = std::max(widest, std::abs(jitter.tilt));
        frictions.insert(jitter.friction_factor);
        CHECK(jitter == jitter_of(7, trial, settings));
    }
    CHECK(frictions.size() == 49);
    CHECK(widest > 0.8 * 2.0 * 3.14159265358979 / 180.0);
}

TEST_CASE("each trial can be run by itself with the motion that was judged",
          "[evolution][trials]") {
    const ExperimentSettings settings = robust(3, "mean");
    const GenomePtr genome = test::crawler(kinds().creature.catalog);
    std::uint64_t all = 0;
    for (int trial = 0; trial < 3; ++trial) {
        const TrialSetup setup = trial_setup(genome, settings, trial);
        const auto record =
            run_trial(std::make_shared<const Phenotype>(express(
                          *setup.genome, kinds().creature, settings.expression, setup.world.scene)),
                      kinds().creature, setup.world);
        REQUIRE(record);
        Hash64 both;
        both.add(all);
        both.add(record->digest);
        all = trial == 0 ? record->digest : both.value();
    }
    CHECK(all == judge(settings).digest);
}

TEST_CASE("the score is the mean or the minimum of the trials", "[evolution][trials]") {
    const std::vector<double> single = scores(robust(3, "mean"));
    REQUIRE(std::set<double>(single.begin(), single.end()).size() == 3);
    const double mean = std::accumulate(single.begin(), single.end(), 0.0) / 3.0;
    CHECK(judge(robust(3, "mean")).fitness == Approx(mean));
    CHECK(judge(robust(3, "minimum")).fitness == *std::min_element(single.begin(), single.end()));
    CHECK(judge(robust(1, "minimum")).fitness == single.front());
}

TEST_CASE("the worse half counts nine times as much as the mean", "[evolution][trials]") {
    std::vector<double> single = scores(robust(4, "mean"));
    const double mean = std::accumulate(single.begin(), single.end(), 0.0) / 4.0;
    std::sort(single.begin(), single.end());
    CHECK(judge(robust(4, "worse half")).fitness ==
          Approx(0.1 * mean + 0.9 * 0.5 * (single[0] + single[1])));
    CHECK(judge(robust(1, "worse half")).fitness == scores(robust(1, "mean")).front());
}

TEST_CASE("several trials have a digest of their own, the same every time", "[evolution][trials]") {
    const EvaluationResult three = judge(robust(3, "mean"));
    CHECK(three.digest == judge(robust(3, "mean")).digest);
    CHECK(three.digest != judge(robust(2, "mean")).digest);
    CHECK(three.digest != judge(robust(1, "mean")).digest);
    CHECK(three.computed_time == Approx(12.0));
}
