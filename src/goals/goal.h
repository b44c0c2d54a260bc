#pragma once

// A goal: the behaviour that evolution selects for, and how a trial is scored (goals/README.md).

#include "core/registry.h"
#include "simulator/trial_record.h"
#include "world/environment.h"

#include <string>
#include <vector>

namespace cambrian {

// One of the quantities that make up a score.
struct ScoreTerm {
    std::string label;
    double value = 0.0;
    std::string unit;
};

struct Score {
    double value = 0.0;  // in the goal's unit; higher is better
    std::vector<ScoreTerm> terms;
};

struct GoalKind {
    std::string id;     // "walking"
    std::string label;  // "Walking"
    std::string unit;   // of the score: "BL/s"
    std::string help;   // one sentence for users
    // Default number of worlds in which scores are confirmed; 0 if a slightly changed trial gives
    // nearly the same score.
    int default_confirmations = 0;
    // Returns the environment in which the goal makes sense.
    Environment (*default_environment)() = nullptr;
    // Returns why the goal is impossible in an environment, as half a sentence; empty if it is
    // possible.
    std::string (*mismatch)(const Environment& environment) = nullptr;
    // Only completed records are scored; others score 0.
    Score (*score)(const TrialRecord& record) = nullptr;
};

using GoalRegistry = Registry<GoalKind>;

GoalRegistry builtin_goals();

// Returns the unit of a goal by its id; empty if the id is unknown.
inline std::string goal_unit(const std::string& goal, const GoalRegistry& goals) {
    const GoalKind* kind = goals.find(goal);
    return kind == nullptr ? std::string() : kind->unit;
}

}  // namespace cambrian
