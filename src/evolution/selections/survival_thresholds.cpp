#include "evolution/selections/survival_thresholds.h"

#include "evolution/selections/survival.h"

#include <algorithm>

namespace cambrian {
namespace {

// With limits on lines and plans, a creature may survive although it is worse than all survivors:
// a better one of the same line or plan as others can take more places away than it needs.
constexpr double kShareOfWorst = 0.5;
// The worst of a full line can also lose its place to a creature of another line but its own plan.
constexpr double kShareOfLine = 0.8;

}  // namespace

SurvivalThresholds::SurvivalThresholds(std::span<const IndividualPtr> survivors,
                                       const ExperimentSettings& settings,
                                       const SelectionKind& selection) {
    const SelectionSettings& limits = settings.selection;
    if (survivors.empty() || !may_terminate_early(selection, limits)) return;
    const auto worst = std::min_element(survivors.begin(), survivors.end(),
                                        [](const IndividualPtr& a, const IndividualPtr& b) {
                                            return a->result.fitness < b->result.fitness;
                                        });
    base_ = (*worst)->result.fitness;
    const SurvivalLimits most = survival_limits(settings);
    if (!most.line && !most.plan) return;
    *base_ *= kShareOfWorst;
    most_of_line_ = most.line.value_or(survivors.size() + 1);
    most_of_plan_ = most.plan.value_or(survivors.size() + 1);
    count(survivors);
}

void SurvivalThresholds::count(std::span<const IndividualPtr> survivors) {
    for (const IndividualPtr& one : survivors) {
        const EvaluationResult& result = one->result;
        of_line_[one->line].push_back(result.fitness);
        of_line_and_plan_[{one->line, result.plan}].push_back(result.fitness);
        ++of_plan_[result.plan];
    }
    // Limits that were dropped for want of other creatures may be dropped again.
    if (!within_limits()) {
        of_line_.clear();
        of_line_and_plan_.clear();
    }
    for (auto& [line, scores] : of_line_)
        std::sort(scores.rbegin(), scores.rend());
    for (auto& [line_and_plan, scores] : of_line_and_plan_)
        std::sort(scores.rbegin(), scores.rend());
}

bool SurvivalThresholds::within_limits() const {
    return std::all_of(of_line_.begin(), of_line_.end(),
                       [&](const auto& line) { return line.second.size() <= most_of_line_; }) &&
           std::all_of(of_plan_.begin(), of_plan_.end(),
                       [&](const auto& plan) { return plan.second <= most_of_plan_; });
}

std::optional<double> SurvivalThresholds::of(std::uint64_t line, std::uint64_t plan) const {
    std::optional<double> least = base_;
    const auto kin = of_line_.find(line);
    if (kin != of_line_.end() && kin->second.size() == most_of_line_)
        least = std::max(*least, kShareOfLine * kin->second.back());
    // If one of these loses its place, then to a better creature that is as much in the way.
    const auto same = of_line_and_plan_.find({line, plan});
    if (same != of_line_and_plan_.end() && same->second.size() == most_of_plan_)
        least = std::max(*least, same->second.back());
    return least;
}

}  // namespace cambrian
