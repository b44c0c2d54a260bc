#include "persist/records/score_text.h"

#include "core/text/number_text.h"
#include "core/text/parsed_number.h"

#include <algorithm>
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
    auto scores = parsed_numbers<double>(text, kMostScores);
    const auto finite = [](double score) { return std::isfinite(score); };
    if (!scores || scores->empty() || !std::all_of(scores->begin(), scores->end(), finite))
        return std::nullopt;
    return scores;
}

}  // namespace cambrian
