#include "studio/viewer/score_words.h"

#include "core/text/pretty_text.h"
#include "core/text/shown_score.h"

#include <fmt/core.h>

#include <algorithm>

namespace cambrian {

std::string confirmed_range(const EvaluationResult& result) {
    if (result.scores.empty()) return {};
    const auto range = std::minmax_element(result.scores.begin(), result.scores.end());
    return fmt::format("{} to {} in {} worlds", shown_score(*range.first, ""),
                       shown_score(*range.second, ""), result.scores.size());
}

}  // namespace cambrian
