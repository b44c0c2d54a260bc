#include "quality/report.h"

#include "comparison/statistics.h"
#include "quality/arm.h"
#include "quality/rounded.h"

#include <iterator>

namespace cambrian::quality {
namespace {

const char* word_of(Finding finding) {
    switch (finding) {
        case Finding::kHolds:
            return "holds";
        case Finding::kFails:
            return "**fails**";
        case Finding::kNotRun:
            break;
    }
    return "not run";
}

std::string all_of(const std::vector<double>& values) {
    std::string text;
    for (const double value : values)
        text += (text.empty() ? "" : " ") + rounded(value);
    return text;
}

std::string row_of(const Arm& arm, const std::vector<RunResult>& runs,
                   const std::vector<double>& random) {
    const std::vector<double> scores = scores_of(runs);
    const Interval interval = median_interval(scores);
    std::string row = "| " + std::string(arm.id) + ": " + std::string(arm.what) + " | " +
                      rounded(median(scores)) + " | " + rounded(interval.low) + " to " +
                      rounded(interval.high) + " | " + all_of(scores) + " | ";
    if (random.empty() || arm.id == kRandomSearch) return row + "| | |\n";
    const RankTest comparison = mann_whitney(scores, random);
    return row + rounded(median(scores) / median(random)) + " | " + rounded(comparison.p) + " | " +
           rounded(comparison.effect) + " |\n";
}

}  // namespace

std::string criteria_table(const std::vector<Criterion>& criteria) {
    std::string text = "| | asked | measured | |\n|---|---|---|---|\n";
    for (const Criterion& criterion : criteria) {
        text += "| " + criterion.id + " | " + criterion.asked + " | " + criterion.found + " | " +
                word_of(criterion.finding) + " |\n";
    }
    return text;
}

std::string arm_tables(const std::vector<RunResult>& runs, std::string_view plan) {
    std::string text;
    std::vector<const char*> goals(std::begin(kGoals), std::end(kGoals));
    goals.push_back(kSeeking);
    for (const char* goal : goals) {
        const auto random = scores_of(runs_of(runs, plan, goal, kRandomSearch));
        std::string rows;
        for (const Arm& arm : all_arms()) {
            const auto some = runs_of(runs, plan, goal, arm.id);
            if (!some.empty()) rows += row_of(arm, some, random);
        }
        if (rows.empty()) continue;
        text += "\n**" + std::string(goal) + "**\n\n" +
                "| arm | median | 90 % interval | every seed | ratio to random search | p | "
                "effect |\n|---|---|---|---|---|---|---|\n" +
                rows;
    }
    return text;
}

}  // namespace cambrian::quality
