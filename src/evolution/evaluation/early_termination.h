#pragma once

// Early termination of trials whose score cannot reach the survivors' (evolution/README.md 4, P5).
// It is a heuristic: it misjudges a creature that rests at first and then moves at more than 1.5
// times its best speed. Therefore a share of the terminated trials is finished anyway and counted.

#include "evolution/settings/experiment_settings.h"
#include "goals/goal.h"
#include "simulator/trial.h"

#include <memory>
#include <optional>
#include <stop_token>

namespace cambrian {

// Early-termination threshold: a trial ends as soon as it can score at most `score`.
struct TerminationThreshold {
    double score = 0.0;
    bool audited = false;  // the trial is finished even if it would be terminated

    friend bool operator==(const TerminationThreshold&, const TerminationThreshold&) = default;
};

// Whether early termination is reliable. It is so after 30 terminated trials were finished anyway.
// The first that would have survived may be chance, so 300 are then to be finished; it is
// unreliable once more than that one, and more than 1 in 1000, would have survived.
struct TerminationAudit {
    static constexpr int kLeastFinished = 30;
    static constexpr int kLeastAfterSurvivor = 300;

    int finished = 0;  // audited trials so far
    int survived = 0;  // audited trials whose creature survived

    bool trustworthy() const { return survived <= 1 || 1000 * survived <= finished; }
    bool proven() const {
        return trustworthy() && finished >= (survived == 0 ? kLeastFinished : kLeastAfterSurvivor);
    }
    friend bool operator==(const TerminationAudit&, const TerminationAudit&) = default;
};

struct TerminableTrial {
    TrialRecord record;
    bool terminable = false;  // terminated early, or audited and would have been terminated
};

// Returns whether a score above the threshold is possible if the rest of the trial moves in one of
// a few directions, at 1.5 times the highest mean speed of any second so far.
bool may_exceed(double threshold, const TrialRecord& so_far, const GoalKind& goal);

// Reasons to end a trial early.
struct TrialEnds {
    const GoalKind& goal;
    const std::optional<TerminationThreshold>& threshold;
    const std::stop_token& stop;
};

// Runs a trial to its end, or until its score cannot exceed the threshold, which is estimated at a
// few moments; without a threshold, always to its end. A long trial ends when a stop is requested,
// as in run_trial().
Result<TerminableTrial> run_terminable_trial(std::shared_ptr<const Phenotype> phenotype,
                                             const Kinds& kinds, const TrialWorld& world,
                                             const TrialEnds& ends);

}  // namespace cambrian
