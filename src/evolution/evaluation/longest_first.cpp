#include "evolution/evaluation/longest_first.h"

#include <algorithm>

namespace cambrian {

void put_longest_first(std::span<std::size_t> indices,
                       std::span<const EvaluationRequest> requests) {
    std::stable_sort(indices.begin(), indices.end(), [&](std::size_t a, std::size_t b) {
        const EvaluationRequest& one = requests[a];
        const EvaluationRequest& other = requests[b];
        const bool one_known = one.expected_work > 0;
        const bool other_known = other.expected_work > 0;
        if (one_known != other_known) return other_known;
        if (one.expected_work != other.expected_work)
            return one.expected_work > other.expected_work;
        return one.genome->nodes.size() > other.genome->nodes.size();
    });
}

std::vector<std::size_t> open_longest_first(
    std::span<const EvaluationRequest> requests,
    std::span<const std::optional<EvaluationResult>> results) {
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < requests.size(); ++i) {
        if (!results[i]) open.push_back(i);
    }
    put_longest_first(open, requests);
    return open;
}

}  // namespace cambrian
