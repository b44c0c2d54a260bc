#pragma once

// Confirmation reduces the influence of chance. Survivors are evaluated again in a few slightly
// different worlds (probe.h), and their fitness becomes the median of all scores. Creatures that
// take the place of a survivor whose score fell
// are evaluated again too, until every survivor has been.

#include "evolution/evaluation/evaluation_backend.h"
#include "evolution/evaluation/probe.h"
#include "evolution/individual/individual.h"

#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <stop_token>
#include <utility>
#include <vector>

namespace cambrian {

// The context of a confirmation.
struct ConfirmingTrials {
    EvaluationBackend& backend;
    const ExperimentSettings& settings;
    EvaluationProgress& progress;
    std::stop_token stop;
    double least_score = 0.0;  // of the goal (GoalKind); a creature that has it is not tried again
};

// Returns whether the creature's score differs from that of the trials by at most a tenth. The
// trials' settings are those of an accurate computation (accurate_settings()). Returns false if
// stopped.
bool is_accurate(const Individual& individual, const ConfirmingTrials& trials);

class Confirmation {
public:
    // The survivors of a ranking, as indices into it.
    using Survivors =
        std::function<std::vector<std::size_t>(std::span<const IndividualPtr> ranked)>;

    // Confirms the survivors of the ranking and sorts it again. Returns false if stopped; finished
    // trials are kept and the call may be repeated.
    bool confirm(std::vector<IndividualPtr>& ranked, const Survivors& survivors,
                 std::span<const Probe> probes, const ConfirmingTrials& trials);

    // Trials run since forget().
    int trials() const { return static_cast<int>(tried_.size()); }
    void forget() { tried_.clear(); }

private:
    bool try_again(const std::vector<IndividualPtr>& creatures, std::span<const Probe> probes,
                   const ConfirmingTrials& trials);
    IndividualPtr confirmed(const Individual& individual, std::span<const Probe> probes) const;

    // Scores, keyed by phenotype and the probe's seed.
    std::map<std::pair<std::uint64_t, std::uint64_t>, double> tried_;
};

}  // namespace cambrian
