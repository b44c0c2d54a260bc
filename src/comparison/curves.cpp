#include "comparison/curves.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace cambrian {
namespace {

// Returns the score after so many trials; nothing before the first generation.
std::optional<double> score_at(const std::vector<CurvePoint>& curve, double trials) {
    const auto later = std::upper_bound(
        curve.begin(), curve.end(), trials,
        [](double limit, const CurvePoint& point) { return limit < point.trials; });
    if (later == curve.begin()) return std::nullopt;
    return std::prev(later)->score;
}

// Returns the quantile of a sorted sample, interpolated linearly between its values.
double quantile(const std::vector<double>& sorted, double share) {
    const double place = share * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(std::floor(place));
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return std::lerp(sorted[below], sorted[above], place - std::floor(place));
}

}  // namespace

CurveBand band_of(const std::vector<ComparedRun>& runs, int points) {
    CurveBand band;
    if (runs.empty()) return band;
    const int most = std::max_element(runs.begin(), runs.end(), [](const auto& a, const auto& b) {
                         return a.trials < b.trials;
                     })->trials;
    for (int i = 1; i <= points; ++i) {
        const double trials = static_cast<double>(most) * i / points;
        std::vector<double> scores;
        for (const ComparedRun& run : runs) {
            if (const auto score = score_at(run.curve, trials)) scores.push_back(*score);
        }
        if (scores.size() < runs.size()) continue;
        std::sort(scores.begin(), scores.end());
        band.trials.push_back(trials);
        band.lower.push_back(quantile(scores, 0.25));
        band.middle.push_back(quantile(scores, 0.5));
        band.upper.push_back(quantile(scores, 0.75));
    }
    return band;
}

}  // namespace cambrian
