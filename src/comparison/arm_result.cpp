#include "comparison/arm_result.h"

#include "core/assert.h"
#include "core/sample_statistics.h"

#include <algorithm>

namespace cambrian {

std::vector<double> confirmed_scores(const std::vector<ComparedRun>& runs) {
    std::vector<double> scores;
    for (const ComparedRun& run : runs)
        scores.push_back(run.confirmed);
    return scores;
}

ArmResult arm_result(const std::vector<ComparedRun>& runs, const std::vector<ComparedRun>& others) {
    CAMBRIAN_ASSERT(!runs.empty(), "an arm without runs has no result");
    const std::vector<double> scores = confirmed_scores(runs);
    ArmResult result{.median = median(scores),
                     .interval = median_interval(scores),
                     .worst = *std::min_element(scores.begin(), scores.end()),
                     .contest = std::nullopt};
    for (const ComparedRun& run : runs)
        result.needing += run.needs_senses;
    if (others.empty()) return result;
    const std::vector<double> theirs = confirmed_scores(others);
    ArmContest contest{.ratio = std::nullopt,
                       .p = two_sided(scores, theirs),
                       .effect = mann_whitney(scores, theirs).effect};
    if (median(theirs) > 0.0) contest.ratio = result.median / median(theirs);
    result.contest = contest;
    return result;
}

}  // namespace cambrian
