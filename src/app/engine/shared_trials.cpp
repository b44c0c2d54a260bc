#include "app/engine/shared_trials.h"

#include "cluster/messages/result_text.h"
#include "evolution/evaluation/longest_first.h"
#include "evolution/evaluation/trials.h"

#include <algorithm>

namespace cambrian {

bool SharedTrials::evaluate(std::span<const EvaluationRequest> requests,
                            std::span<std::optional<EvaluationResult>> results,
                            const ExperimentSettings& settings, EvaluationProgress& /*progress*/,
                            std::stop_token /*stop*/) {
    const std::vector<std::size_t> open = open_longest_first(requests, results);
    if (open.empty()) return true;
    if (requests_.empty()) {
        settings_ = &settings;
        for (const std::size_t index : open)
            requests_.push_back(requests[index]);
        results_.assign(open.size(), std::nullopt);
        return false;
    }
    if (!std::all_of(results_.begin(), results_.end(), [](const auto& each) { return each; }))
        return false;
    for (std::size_t i = 0; i < open.size(); ++i)
        results[open[i]] = std::move(results_[i]);
    requests_.clear();
    results_.clear();
    return true;
}

std::string SharedTrials::run(std::size_t index) {
    results_[index] = evaluate_in_trials(requests_[index], *settings_, *kinds_);
    return result_text(*results_[index]);
}

Status SharedTrials::take(std::size_t index, std::string_view result) {
    Result<EvaluationResult> read = parse_result(result);
    if (!read) return read.error();
    results_[index] = *std::move(read);
    return {};
}

}  // namespace cambrian
