#include "studio/comparison/comparison_results.h"

#include "comparison/comparison.h"
#include "comparison/report.h"

#include <algorithm>

namespace cambrian {
namespace {

constexpr int kPoints = 120;  // of a curve

ComparedArm compared_arm(const std::string& name, const std::vector<ComparedRun>& runs,
                         const std::vector<ComparedRun>& reference,
                         const std::filesystem::path& folder) {
    ComparedArm arm{
        .name = name, .finished = runs.size(), .result = {}, .band = {}, .champion = {}};
    if (runs.empty()) return arm;
    arm.result = arm_result(runs, reference);
    arm.band = band_of(runs, kPoints);
    const auto best = std::max_element(
        runs.begin(), runs.end(),
        [](const ComparedRun& a, const ComparedRun& b) { return a.confirmed < b.confirmed; });
    arm.champion = champion_file(folder, *best);
    return arm;
}

}  // namespace

std::size_t ComparisonResults::finished() const {
    std::size_t sum = 0;
    for (const ComparedArm& arm : arms)
        sum += arm.finished;
    return sum;
}

std::size_t ComparisonResults::planned_runs() const {
    return planned * arms.size();
}

ComparisonResults results_of(const std::vector<std::string>& arms, std::size_t planned,
                             const std::vector<ComparedRun>& finished,
                             const std::filesystem::path& folder) {
    ComparisonResults results;
    results.planned = planned;
    const std::string world = finished.empty() ? "" : finished.front().world;
    const std::vector<ComparedRun> first = runs_of(finished, world, arms.front());
    for (const std::string& arm : arms) {
        const bool reference = results.arms.empty();
        results.arms.push_back(compared_arm(arm, runs_of(finished, world, arm),
                                            reference ? std::vector<ComparedRun>{} : first,
                                            folder));
    }
    return results;
}

}  // namespace cambrian
