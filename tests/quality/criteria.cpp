#include "quality/criteria.h"

#include "comparison/statistics.h"
#include "quality/arm.h"
#include "quality/rounded.h"

#include <algorithm>
#include <functional>

namespace cambrian::quality {
namespace {

constexpr const char* kStandard = "standard";

std::string percent(double share) {
    return rounded(100.0 * share) + " %";
}

Criterion judged(std::string id, std::string asked, std::string found, bool holds) {
    return {std::move(id), std::move(asked), std::move(found),
            holds ? Finding::kHolds : Finding::kFails};
}

// A comparison of evolution, or of a variant, with random search or another arm.
struct Duel {
    const char* id;
    std::string_view plan;
    std::string_view goal;
    std::string_view arm;
    std::string_view against;
    double least_ratio;  // least ratio of medians
    double most_p;       // largest p value of the U test
};

Criterion fight(const std::vector<RunResult>& runs, const Duel& duel) {
    std::string asked = std::string(duel.arm) + " over " + std::string(duel.against) + ", " +
                        std::string(duel.goal) + ": ratio of medians at least " +
                        rounded(duel.least_ratio);
    if (duel.most_p < 1.0) asked += " and p < " + rounded(duel.most_p);
    const auto ours = scores_of(runs_of(runs, duel.plan, duel.goal, duel.arm));
    const auto theirs = scores_of(runs_of(runs, duel.plan, duel.goal, duel.against));
    if (ours.empty() || theirs.empty()) return {duel.id, asked, {}, Finding::kNotRun};
    // Scores of seekers may be negative; a positive median is any number of times such a one.
    const bool comparable = median(theirs) > 0.0;
    const double ratio = comparable           ? median(ours) / median(theirs)
                         : median(ours) > 0.0 ? 1e6
                                              : 0.0;
    const RankTest comparison = mann_whitney(ours, theirs);
    const std::string found = rounded(median(ours)) + " against " + rounded(median(theirs)) +
                              (comparable ? ": ratio " + rounded(ratio) : "") + ", p " +
                              rounded(comparison.p) + ", effect " + rounded(comparison.effect);
    return judged(duel.id, asked, found,
                  ratio >= duel.least_ratio && (duel.most_p >= 1.0 || comparison.p < duel.most_p));
}

Criterion reaches(const std::vector<RunResult>& runs, const char* goal, double least,
                  const char* unit) {
    const std::string asked =
        "median of evolution, " + std::string(goal) + ", at least " + rounded(least) + " " + unit;
    const auto scores = scores_of(runs_of(runs, kStandard, goal, kEvolution));
    if (scores.empty()) return {"B2", asked, {}, Finding::kNotRun};
    return judged("B2", asked, rounded(median(scores)) + " " + unit, median(scores) >= least);
}

Criterion breeds_better(const std::vector<RunResult>& runs, std::string_view method) {
    constexpr double kLeast = 0.003;
    const std::string asked = "share of children by " + std::string(method) +
                              " fitter than all their parents, walking, at least " +
                              percent(kLeast);
    Offspring sum;
    for (const RunResult& run : runs_of(runs, kStandard, kGoals[0], kEvolution)) {
        const auto offspring = run.offspring.find(std::string(method));
        if (offspring == run.offspring.end()) continue;
        sum.born += offspring->second.born;
        sum.improved += offspring->second.improved;
    }
    if (sum.born == 0) return {"B4", asked, {}, Finding::kNotRun};
    const double share = static_cast<double>(sum.improved) / sum.born;
    return judged("B4", asked,
                  percent(share) + " (" + std::to_string(sum.improved) + " of " +
                      std::to_string(sum.born) + ")",
                  share >= kLeast);
}

using Test = std::function<bool(const RunResult&)>;

Criterion counted(const char* id, std::string asked, const std::vector<RunResult>& runs,
                  const Test& test, const std::function<bool(std::ptrdiff_t, std::size_t)>& holds) {
    if (runs.empty()) return {id, std::move(asked), {}, Finding::kNotRun};
    const auto count = std::count_if(runs.begin(), runs.end(), test);
    return judged(id, std::move(asked),
                  std::to_string(count) + " of " + std::to_string(runs.size()),
                  holds(count, runs.size()));
}

bool none(std::ptrdiff_t count, std::size_t /*of*/) {
    return count == 0;
}

bool seven_of_nine(std::ptrdiff_t count, std::size_t of) {
    return 9 * count >= 7 * static_cast<std::ptrdiff_t>(of);
}

Criterion repeats(const std::vector<RunResult>& runs, const char* goal) {
    const std::string asked = "the same run again gives the same bits, " + std::string(goal);
    const auto first = runs_of(runs, kStandard, goal, kEvolution);
    const auto again = runs_of(runs, kStandard, goal, kRepeated);
    if (first.empty() || again.empty()) return {"B8", asked, {}, Finding::kNotRun};
    const bool same = first.front().digest == again.front().digest;
    return judged("B8", asked, same ? "the same" : "other bits", same);
}

Criterion spreads(const std::vector<RunResult>& runs, const char* what,
                  const std::function<double(const RunResult&)>& measure) {
    constexpr double kLeast = 1.3;
    const std::string asked =
        "map-elites over evolution, walking: " + std::string(what) + " at least 1.3 times";
    const auto median_of = [&](std::string_view arm) {
        std::vector<double> values;
        for (const RunResult& run : runs_of(runs, kStandard, kGoals[0], arm))
            values.push_back(measure(run));
        return values.empty() ? 0.0 : median(values);
    };
    const double usual = median_of(kEvolution);
    const double map = median_of(kMapElites);
    if (usual <= 0.0 || map <= 0.0) return {"B9", asked, {}, Finding::kNotRun};
    return judged("B9", asked,
                  rounded(map) + " against " + rounded(usual) + ": ratio " + rounded(map / usual),
                  map / usual >= kLeast);
}

std::vector<RunResult> of_plan(const std::vector<RunResult>& runs, std::string_view plan) {
    std::vector<RunResult> some;
    std::copy_if(runs.begin(), runs.end(), std::back_inserter(some),
                 [&](const RunResult& run) { return run.plan == plan; });
    return some;
}

}  // namespace

std::vector<RunResult> runs_of(const std::vector<RunResult>& runs, std::string_view plan,
                               std::string_view goal, std::string_view arm) {
    std::vector<RunResult> some;
    std::copy_if(runs.begin(), runs.end(), std::back_inserter(some), [&](const RunResult& run) {
        return run.plan == plan && run.goal == goal && run.arm == arm;
    });
    std::sort(some.begin(), some.end(),
              [](const RunResult& a, const RunResult& b) { return a.seed < b.seed; });
    return some;
}

std::vector<double> scores_of(const std::vector<RunResult>& runs) {
    std::vector<double> scores;
    scores.reserve(runs.size());
    for (const RunResult& run : runs)
        scores.push_back(run.best);
    return scores;
}

std::vector<Criterion> standard_criteria(const std::vector<RunResult>& runs) {
    std::vector<Criterion> criteria;
    for (const char* goal : kGoals)
        criteria.push_back(fight(runs, {"B1", kStandard, goal, kEvolution, kRandomSearch, 2, .01}));
    criteria.push_back(reaches(runs, "walking", 0.6, "BL/s"));
    criteria.push_back(reaches(runs, "swimming", 0.12, "BL/s"));
    criteria.push_back(reaches(runs, "jumping", 0.3, "m"));
    for (const std::string_view method : kBreedingArms) {
        criteria.push_back(
            fight(runs, {"B3", kStandard, kGoals[0], method, kRandomSearch, 1.5, .05}));
    }
    for (const std::string_view method : kBreedingArms)
        criteria.push_back(breeds_better(runs, method));
    criteria.push_back(fight(runs, {"B5", kStandard, kGoals[0], kEvolution, kNoMutation, 1, .05}));
    const auto walkers = runs_of(runs, kStandard, kGoals[0], kEvolution);
    criteria.push_back(counted(
        "B6", "walking champions that move less than 0.1 body lengths in the last 30 %: none",
        walkers, [](const RunResult& run) { return run.late_travel < 0.1; }, none));
    criteria.push_back(counted(
        "B7", "walking champions that keep half their score when computed finer: 7 of 9", walkers,
        [](const RunResult& run) { return run.finer >= 0.5 * run.final_best; }, seven_of_nine));
    criteria.push_back(counted(
        "B8", "runs in which the best of a generation was below that of the one before: none",
        of_plan(runs, kStandard), [](const RunResult& run) { return run.decreased; }, none));
    for (const char* goal : kGoals)
        criteria.push_back(repeats(runs, goal));
    criteria.push_back(spreads(
        runs, "filled cells", [](const RunResult& run) { return static_cast<double>(run.cells); }));
    criteria.push_back(spreads(runs, "QD-score", [](const RunResult& run) { return run.quality; }));
    return criteria;
}

std::vector<Criterion> long_criteria(const std::vector<RunResult>& runs) {
    std::vector<Criterion> criteria;
    for (const char* goal : kGoals)
        criteria.push_back(fight(runs, {"L", "long", goal, kEvolution, kRandomSearch, 3, 1}));
    return criteria;
}

std::vector<Criterion> seeking_criteria(const std::vector<RunResult>& runs) {
    return {fight(runs, {"S1", "seeking", kSeeking, kEvolution, kRandomSearch, 2, 0.01}),
            fight(runs, {"S2", "seeking", kSeeking, kEvolution, kBlind, 1.5, 0.01})};
}

std::vector<Criterion> quick_criteria(const std::vector<RunResult>& runs) {
    std::vector<Criterion> criteria = {
        fight(runs, {"Q", "quick", "swimming", kEvolution, kRandomSearch, 1.8, 1}),
        fight(runs, {"Q", "quick", "walking", kEvolution, kRandomSearch, 2.0, 1})};
    criteria.push_back(counted(
        "Q", "champions whose audit is not clean: none", of_plan(runs, "quick"),
        [](const RunResult& run) { return !run.clean; }, none));
    return criteria;
}

}  // namespace cambrian::quality
