#pragma once

// The result of an arm's finished runs in one world: their median, and how it compares with
// another arm.

#include "comparison/compared_run.h"
#include "comparison/statistics.h"

#include <optional>
#include <vector>

namespace cambrian {

// An arm against another. The tests are Mann-Whitney's, of the confirmed scores.
struct ArmContest {
    std::optional<double> ratio;  // of the medians; none if the other's is not positive
    double p = 1.0;               // two-sided
    double effect = 0.5;          // probability that a run of the arm is better
};

struct ArmResult {
    double median = 0.0;  // of the confirmed scores
    Interval interval;    // 90 % bootstrap interval of the median
    double worst = 0.0;   // lowest confirmed score
    int needing = 0;      // champions that need their senses (needs_senses())
    std::optional<ArmContest> contest;
};

// Returns the confirmed scores of the runs.
std::vector<double> confirmed_scores(const std::vector<ComparedRun>& runs);

// Returns the result of an arm. `others` are the runs of the arm that it is measured against;
// without any there is no contest. There must be runs of the arm itself.
ArmResult arm_result(const std::vector<ComparedRun>& runs, const std::vector<ComparedRun>& others);

}  // namespace cambrian
