#include "evolution/evaluation/confirmation.h"

#include "core/sample_statistics.h"
#include "evolution/evaluation/trials.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

namespace cambrian {
namespace {

// Greatest difference of an accurate score, relative to it.
constexpr double kAccuracy = 0.1;

// Returns whether other worlds can lower the creature's score.
bool unconfirmed(const EvaluationResult& result, double least_score) {
    return result.outcome == Outcome::kCompleted && result.fitness > least_score &&
           result.scores.empty();
}

}  // namespace

bool is_accurate(const Individual& individual, const ConfirmingTrials& trials) {
    const EvaluationRequest request{.genome = individual.genome,
                                    .trial_seed = trial_seed(trials.settings),
                                    .expected_work = individual.result.work};
    std::optional<EvaluationResult> result;
    if (!trials.backend.evaluate({&request, 1}, {&result, 1}, trials.settings, trials.progress,
                                 trials.stop))
        return false;
    const double score = individual.result.fitness;
    return result->outcome == Outcome::kCompleted &&
           std::fabs(result->fitness - score) <= kAccuracy * std::fabs(score);
}

bool Confirmation::confirm(std::vector<IndividualPtr>& ranked, const Survivors& survivors,
                           std::span<const Probe> probes, const ConfirmingTrials& trials) {
    while (!probes.empty()) {
        std::vector<std::size_t> places = survivors(ranked);
        std::erase_if(places, [&](std::size_t i) {
            return !unconfirmed(ranked[i]->result, trials.least_score);
        });
        if (places.empty()) return true;
        std::vector<IndividualPtr> creatures;
        creatures.reserve(places.size());
        for (const std::size_t place : places)
            creatures.push_back(ranked[place]);
        if (!try_again(creatures, probes, trials)) return false;
        for (const std::size_t place : places)
            ranked[place] = confirmed(*ranked[place], probes);
        std::sort(ranked.begin(), ranked.end(),
                  [](const IndividualPtr& a, const IndividualPtr& b) { return better(*a, *b); });
    }
    return true;
}

// Requests a trial in each world for every phenotype, except trials that were run before.
bool Confirmation::try_again(const std::vector<IndividualPtr>& creatures,
                             std::span<const Probe> probes, const ConfirmingTrials& trials) {
    std::vector<EvaluationRequest> requests;
    std::vector<std::pair<std::uint64_t, std::uint64_t>> keys;
    std::set<std::uint64_t> phenotypes;
    for (const IndividualPtr& one : creatures) {
        if (!phenotypes.insert(one->result.phenotype).second) continue;
        for (const Probe& probe : probes) {
            const std::pair key(one->result.phenotype, probe.seed);
            if (tried_.count(key) > 0) continue;
            keys.push_back(key);
            requests.push_back({.genome = one->genome,
                                .trial_seed = trial_seed(trials.settings),
                                .expected_work = one->result.work,
                                .probe = probe});
        }
    }
    std::vector<std::optional<EvaluationResult>> results(requests.size());
    EvaluationProgress confirming;  // readers count creatures, not how often each is tried
    const bool whole =
        trials.backend.evaluate(requests, results, trials.settings, confirming, trials.stop);
    for (std::size_t i = 0; i < results.size(); ++i) {
        if (results[i]) tried_.emplace(keys[i], results[i]->fitness);
    }
    return whole;
}

IndividualPtr Confirmation::confirmed(const Individual& individual,
                                      std::span<const Probe> probes) const {
    Individual one = individual;
    one.result.scores = {one.result.fitness};
    for (const Probe& probe : probes)
        one.result.scores.push_back(tried_.at({one.result.phenotype, probe.seed}));
    one.result.fitness = median(one.result.scores);
    return std::make_shared<const Individual>(std::move(one));
}

}  // namespace cambrian
