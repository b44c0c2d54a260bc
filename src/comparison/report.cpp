#include "comparison/report.h"

#include "comparison/arm_result.h"
#include "core/sample_statistics.h"
#include "core/text/counted.h"
#include "core/text/pretty_text.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace cambrian {
namespace {

// Largest relative difference of a finer score that counts as agreement.
constexpr double kAgrees = 0.1;

std::string rounded(double value) {
    return fmt::format("{:.3g}", value);
}

template <class Number>
std::vector<double> column(const std::vector<ComparedRun>& runs, Number ComparedRun::*field) {
    std::vector<double> values;
    for (const ComparedRun& run : runs)
        values.push_back(static_cast<double>(run.*field));
    return values;
}

std::vector<std::string> distinct(const std::vector<ComparedRun>& runs,
                                  std::string ComparedRun::*field) {
    std::vector<std::string> names;
    for (const ComparedRun& run : runs) {
        if (std::find(names.begin(), names.end(), run.*field) == names.end())
            names.push_back(run.*field);
    }
    return names;
}

// Returns the ratio of two medians, as in "0.73"; empty if it does not exist.
std::string ratio_text(double ours, double theirs) {
    return theirs > 0.0 ? rounded(ours / theirs) : "";
}

std::string against(const ArmContest& contest) {
    return fmt::format("{} | {} | {}", contest.ratio ? rounded(*contest.ratio) : "",
                       rounded(contest.p), rounded(contest.effect));
}

std::string row(const std::string& arm, const std::vector<ComparedRun>& runs,
                const std::vector<ComparedRun>& first) {
    const bool reference = first.empty() || first.front().arm == arm;
    const ArmResult result = arm_result(runs, reference ? std::vector<ComparedRun>{} : first);
    const auto exact = std::count_if(runs.begin(), runs.end(), [](const ComparedRun& run) {
        return std::fabs(run.finer - run.score) <= kAgrees * std::fabs(run.score);
    });
    std::string text =
        fmt::format("| {} | {} | {} | {} to {} | {}", arm, runs.size(), rounded(result.median),
                    rounded(result.interval.low), rounded(result.interval.high),
                    ratio_text(result.worst, result.median));
    text += " | " + (result.contest ? against(*result.contest) : " |  | ");
    text += " | " + rounded(median(column(runs, &ComparedRun::score)));
    text += fmt::format(" | {}", exact);
    for (const auto field :
         {&ComparedRun::lines, &ComparedRun::plans, &ComparedRun::parts, &ComparedRun::generations})
        text += " | " + rounded(median(column(runs, field)));
    text += fmt::format(" | {} of {}", result.needing, runs.size());
    text += " | " + rounded(median(column(runs, &ComparedRun::jump_height)));
    text += fmt::format(" | {} %", rounded(100.0 * mean(column(runs, &ComparedRun::time_saved))));
    const auto sum = [](const std::vector<double>& values) {
        return rounded(mean(values) * static_cast<double>(values.size()));
    };
    text += fmt::format(" | {} of {}", sum(column(runs, &ComparedRun::survivors)),
                        sum(column(runs, &ComparedRun::audited)));
    return text + " |\n";
}

constexpr const char* kHead =
    "| arm | runs | confirmed | 90 % interval | worst / median | ratio | p | effect | score | "
    "finer within 10 % | lines | plans of 20 | parts | generations | need senses | jump, m | time "
    "saved | "
    "audited survivors |\n"
    "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n";

// Reports the mean of each arm's ratio to the first arm over all worlds in which both were run.
std::string overall(const std::vector<ComparedRun>& runs) {
    const std::vector<std::string> arms = arms_of(runs);
    std::string text;
    for (std::size_t i = 1; i < arms.size(); ++i) {
        double sum = 0.0;
        std::size_t count = 0;
        for (const std::string& world : worlds_of(runs)) {
            const auto ours = confirmed_scores(runs_of(runs, world, arms[i]));
            const auto theirs = confirmed_scores(runs_of(runs, world, arms[0]));
            if (ours.empty() || theirs.empty()) continue;
            const double ratio = median(ours) / median(theirs);
            if (!(ratio > 0.0) || !std::isfinite(ratio)) continue;
            sum += std::log(ratio);
            ++count;
        }
        if (count == 0) continue;
        text += fmt::format("- {} against {}: {}, geometric mean over {}\n", arms[i], arms[0],
                            rounded(std::exp(sum / static_cast<double>(count))),
                            counted(count, "world"));
    }
    return text;
}

}  // namespace

std::vector<ComparedRun> runs_of(const std::vector<ComparedRun>& runs, const std::string& world,
                                 const std::string& arm) {
    std::vector<ComparedRun> some;
    std::copy_if(runs.begin(), runs.end(), std::back_inserter(some),
                 [&](const ComparedRun& run) { return run.world == world && run.arm == arm; });
    return some;
}

std::vector<std::string> worlds_of(const std::vector<ComparedRun>& runs) {
    return distinct(runs, &ComparedRun::world);
}

std::vector<std::string> arms_of(const std::vector<ComparedRun>& runs) {
    return distinct(runs, &ComparedRun::arm);
}

std::string comparison_report(const std::vector<ComparedRun>& runs) {
    std::string text;
    const std::vector<std::string> arms = arms_of(runs);
    for (const std::string& world : worlds_of(runs)) {
        text += fmt::format("**{}**\n\n{}", world, kHead);
        const std::vector<ComparedRun> first = runs_of(runs, world, arms.front());
        for (const std::string& arm : arms) {
            const std::vector<ComparedRun> some = runs_of(runs, world, arm);
            if (!some.empty()) text += row(arm, some, first);
        }
        text += "\n";
    }
    return text + overall(runs);
}

}  // namespace cambrian
