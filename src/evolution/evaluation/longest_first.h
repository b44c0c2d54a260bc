#pragma once

#include "evolution/evaluation/evaluation.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace cambrian {

// Sorts indices of requests so that the longest evaluations start first and no core waits long at
// the end. Requests of unknown work come first, larger bodies before smaller ones; the others
// follow by falling expected work. No result depends on it.
void put_longest_first(std::span<std::size_t> indices, std::span<const EvaluationRequest> requests);

// The indices of the requests without a result, in that order.
std::vector<std::size_t> open_longest_first(
    std::span<const EvaluationRequest> requests,
    std::span<const std::optional<EvaluationResult>> results);

}  // namespace cambrian
