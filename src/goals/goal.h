#pragma once

// A goal: the behaviour that evolution selects for, and how a trial is scored (goals/README.md).

#include "core/registry.h"
#include "simulator/settings/trial_settings.h"
#include "simulator/trial_record.h"
#include "world/environment.h"

#include <span>
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
    // Name of a sample creature that the goal displays before a run has creatures: "walker" is
    // walker.creature.json. Empty for none.
    std::string sample = {};
    // Default number of worlds in which scores are confirmed; 0 if a slightly changed trial gives
    // nearly the same score.
    int default_confirmations = 0;
    // Returns the environment in which the goal makes sense.
    Environment (*default_environment)() = nullptr;
    TrialSettings default_trial = {};  // default protocol of the goal's trials
    // Ids of sensor channels. If any are listed, the goal needs at least one of them enabled and,
    // if they are of light, a light in the environment.
    std::vector<std::string> senses = {};
    // Usual senses that are off by default, since selection would hardly find those above among
    // them.
    std::vector<std::string> distractions = {};
    // Allows early termination of trials, which extrapolates from the best speed so far.
    bool may_give_up = true;
    // Default of early termination: whether that saves a noticeable share of the time.
    bool default_give_up = false;
    // Creatures contend with opponents for a cube. A run draws the opponents of each generation
    // from its earlier champions (evolution/opponents.h).
    bool is_contest = false;
    // Returns why the goal is impossible in an environment, as half a sentence; empty if it is
    // possible.
    std::string (*mismatch)(const Environment& environment) = nullptr;
    // No trial scores less. A trial that fails has this score where a number is needed, as in the
    // median of several worlds.
    double least_score = 0.0;
    // Scores a completed record, or the beginning of one.
    Score (*score)(const TrialRecord& record) = nullptr;
    // A goal that judges all trials of a creature together sets both. `shares` returns the numbers
    // of one trial, `score_of_shares` the score of the numbers of all trials. If null, the scores
    // of the trials are combined (TrialSettings::combine).
    std::vector<double> (*shares)(const TrialRecord& record) = nullptr;
    double (*score_of_shares)(std::span<const double> shares) = nullptr;
};

using GoalRegistry = Registry<GoalKind>;

GoalRegistry builtin_goals();

// Returns why a goal is impossible in an environment, as half a sentence; empty if it is possible.
inline std::string mismatch_of(const GoalKind& goal, const Environment& environment) {
    return goal.mismatch == nullptr ? std::string() : goal.mismatch(environment);
}

// Returns the unit of a goal by its id; empty if the id is unknown.
inline std::string goal_unit(const std::string& goal, const GoalRegistry& goals) {
    const GoalKind* kind = goals.find(goal);
    return kind == nullptr ? std::string() : kind->unit;
}

}  // namespace cambrian
