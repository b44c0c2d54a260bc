#include "studio/viewer/score_words.h"

#include "core/text/pretty_text.h"

#include <algorithm>

namespace cambrian {

std::string confirmed_range(const EvaluationResult& result) {
    if (result.scores.empty()) return {};
    const auto range = std::minmax_element(result.scores.begin(), result.scores.end());
    return measured(*range.first, "") + " to " + measured(*range.second, "") + " in " +
           std::to_string(result.scores.size()) + " worlds";
}

}  // namespace cambrian
