#include "persist/records/score_text.h"

#include "core/text/number_text.h"

#include <charconv>
#include <cmath>

namespace cambrian {
namespace {

constexpr std::size_t kMostScores = 100;

}  // namespace

std::string scores_text(std::span<const double> scores) {
    std::string text;
    for (const double score : scores)
        text += (text.empty() ? "" : " ") + real_text(score);
    return text;
}

std::optional<std::vector<double>> parse_scores(std::string_view text) {
    std::vector<double> scores;
    const char* at = text.data();
    const char* const end = at + text.size();
    while (scores.size() < kMostScores) {
        double score = 0.0;
        const auto [after, failure] = std::from_chars(at, end, score);
        if (failure != std::errc() || !std::isfinite(score)) return std::nullopt;
        scores.push_back(score);
        if (after == end) return scores;
        if (*after != ' ') return std::nullopt;
        at = after + 1;
    }
    return std::nullopt;
}

}  // namespace cambrian
