#pragma once

// What the finished runs say of the quality of evolution: criteria of quality/README.md 2 and 3.

#include "quality/run.h"

#include <string>
#include <vector>

namespace cambrian::quality {

enum class Finding { kHolds, kFails, kNotRun };

struct Criterion {
    std::string id;     // "B1 walking"
    std::string asked;  // what is to hold
    std::string found;  // what was measured; empty if it was not
    Finding finding = Finding::kNotRun;
};

std::vector<Criterion> standard_criteria(const std::vector<RunResult>& runs);
std::vector<Criterion> long_criteria(const std::vector<RunResult>& runs);
std::vector<Criterion> quick_criteria(const std::vector<RunResult>& runs);

// The runs of one arm, in the order of their seeds.
std::vector<RunResult> runs_of(const std::vector<RunResult>& runs, std::string_view plan,
                               std::string_view goal, std::string_view arm);
// What each came to when its budget was used up.
std::vector<double> scores_of(const std::vector<RunResult>& runs);

}  // namespace cambrian::quality
