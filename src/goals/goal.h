#pragma once

// What is asked of a creature and how its trial is scored (goals/README.md).

#include "core/registry.h"
#include "simulator/trial_record.h"
#include "world/environment.h"

#include <string>
#include <vector>

namespace cambrian {

// One line of how a score was made up.
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
    std::string help;   // one sentence for people
    // Worlds in which scores are confirmed unless settings say otherwise; 0 where a trial that is
    // repeated slightly differently comes to the same.
    int default_confirmations = 0;
    // The environment the goal makes sense in.
    Environment (*default_environment)() = nullptr;
    // What makes the goal pointless in an environment, as half a sentence; empty if nothing does.
    std::string (*mismatch)(const Environment& environment) = nullptr;
    // Only completed records are scored; others score 0.
    Score (*score)(const TrialRecord& record) = nullptr;
};

using GoalRegistry = Registry<GoalKind>;

GoalRegistry builtin_goals();

// The unit of a goal (by its id); empty if it is not known.
inline std::string goal_unit(const std::string& goal, const GoalRegistry& goals) {
    const GoalKind* kind = goals.find(goal);
    return kind == nullptr ? std::string() : kind->unit;
}

}  // namespace cambrian
