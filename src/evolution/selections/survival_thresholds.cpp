#include "evolution/selections/survival_thresholds.h"

#include "evolution/selections/survival.h"

#include <cmath>

namespace cambrian {
namespace {

// With limits on lines and plans, a creature may survive although it is worse than all survivors:
// a better one of the same line or plan as others can take more places away than it needs.
constexpr double kShareOfWorst = 0.5;
// The worst of a full line can also lose its place to a creature of another line but its own plan.
constexpr double kShareOfLine = 0.8;

// Lowers a score by a share of its size; one that is negative becomes more so.
double lowered_to(double share, double score) {
    return score - (1.0 - share) * std::fabs(score);
}

}  // namespace

SurvivalThresholds::SurvivalThresholds(std::span<const IndividualPtr> survivors,
                                       const ExperimentSettings& settings,
                                       const SelectionKind& selection) {
    if (survivors.empty() || !may_terminate_early(selection, settings)) return;
    Group all;
    for (const IndividualPtr& one : survivors) {
        if (shortfall(one->result.outcome) > 0) return;  // whoever completes its trial survives
        all.add(one->result.fitness);
    }
    const SurvivalLimits most = survival_limits(settings);
    const bool limited = most.line || most.plan;
    base_ = limited ? lowered_to(kShareOfWorst, all.worst) : all.worst;
    if (!limited) return;
    most_of_line_ = most.line.value_or(survivors.size() + 1);
    most_of_plan_ = most.plan.value_or(survivors.size() + 1);
    group(survivors);
}

void SurvivalThresholds::group(std::span<const IndividualPtr> survivors) {
    std::map<std::uint64_t, Group> plans;
    for (const IndividualPtr& one : survivors) {
        const EvaluationResult& result = one->result;
        lines_[one->line].add(result.fitness);
        plans[result.plan].add(result.fitness);
        lines_and_plans_[{one->line, result.plan}].add(result.fitness);
    }
    const auto exceeds = [](const auto& groups, std::size_t most) {
        return std::any_of(groups.begin(), groups.end(),
                           [most](const auto& each) { return each.second.size > most; });
    };
    // Limits that were dropped for want of other creatures may be dropped again.
    if (exceeds(lines_, most_of_line_) || exceeds(plans, most_of_plan_)) {
        lines_.clear();
        lines_and_plans_.clear();
    }
}

std::optional<double> SurvivalThresholds::of(std::uint64_t line, std::uint64_t plan) const {
    std::optional<double> least = base_;
    const auto kin = lines_.find(line);
    if (kin != lines_.end() && kin->second.size == most_of_line_)
        least = std::max(*least, lowered_to(kShareOfLine, kin->second.worst));
    // If one of these loses its place, then to a better creature that is as much in the way.
    const auto same = lines_and_plans_.find({line, plan});
    if (same != lines_and_plans_.end() && same->second.size == most_of_plan_)
        least = std::max(*least, same->second.worst);
    return least;
}

}  // namespace cambrian
