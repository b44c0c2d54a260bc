#pragma once

// Evaluates the criteria of quality/README.md 2 and 3 on the finished runs.

#include "quality/run.h"

#include <string>
#include <vector>

namespace cambrian::quality {

enum class Finding { kHolds, kFails, kNotRun };

struct Criterion {
    std::string id;     // "B1 walking"
    std::string asked;  // the required result
    std::string found;  // the measured result; empty if it was not measured
    Finding finding = Finding::kNotRun;
};

std::vector<Criterion> standard_criteria(const std::vector<RunResult>& runs);
std::vector<Criterion> long_criteria(const std::vector<RunResult>& runs);
std::vector<Criterion> seeking_criteria(const std::vector<RunResult>& runs);
std::vector<Criterion> quick_criteria(const std::vector<RunResult>& runs);

// Returns the runs of one arm, ordered by seed.
std::vector<RunResult> runs_of(const std::vector<RunResult>& runs, std::string_view plan,
                               std::string_view goal, std::string_view arm);
// Returns each run's best fitness when its budget was used up.
std::vector<double> scores_of(const std::vector<RunResult>& runs);

}  // namespace cambrian::quality
