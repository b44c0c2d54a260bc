#pragma once

// Early termination of trials whose score cannot reach the survivors' (evolution/README.md 4, P5).
// It is a heuristic: it misjudges a creature that rests for half its trial and then moves at more
// than 1.5 times its best speed. Therefore a share of the terminated trials is finished anyway and
// counted.

#include "evolution/settings/experiment_settings.h"
#include "goals/goal.h"
#include "simulator/trial.h"

#include <memory>
#include <optional>
#include <stop_token>

namespace cambrian {

// Early-termination threshold: a trial ends halfway if it can score at most `score`.
struct TerminationThreshold {
    double score = 0.0;
    bool audited = false;  // the trial is finished even if it would be terminated

    friend bool operator==(const TerminationThreshold&, const TerminationThreshold&) = default;
};

// Whether early termination is reliable. It is so after 30 terminated trials were finished anyway,
// and as long as at most 1 in 1000 of them would have survived.
struct TerminationAudit {
    static constexpr int kLeastFinished = 30;

    int finished = 0;  // audited trials so far
    int survived = 0;  // audited trials whose creature survived

    bool trustworthy() const { return 1000 * survived <= finished; }
    bool proven() const { return trustworthy() && finished >= kLeastFinished; }
    friend bool operator==(const TerminationAudit&, const TerminationAudit&) = default;
};

struct TerminableTrial {
    TrialRecord record;
    bool terminable = false;  // terminated early, or audited and would have been terminated
};

// Returns the best score possible if the rest of the trial moves in one of a few directions, at 1.5
// times the highest mean speed of any second so far.
double most_still_possible(const TrialRecord& so_far, const GoalKind& goal);

// Reasons to end a trial early.
struct TrialEnds {
    const GoalKind& goal;
    const std::optional<TerminationThreshold>& threshold;
    const std::stop_token& stop;
};

// Runs a trial to its end, or until its score cannot reach the threshold; without a threshold,
// always to its end. A long trial ends when a stop is requested, as in run_trial().
Result<TerminableTrial> run_terminable_trial(std::shared_ptr<const Phenotype> phenotype,
                                             const Kinds& kinds, const TrialWorld& world,
                                             const TrialEnds& ends);

}  // namespace cambrian
