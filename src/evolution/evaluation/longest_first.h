#pragma once

#include "evolution/evaluation/evaluation.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace cambrian {

// Sorts indices of requests so that the longest evaluations start first and no core waits long at
// the end. Requests of unknown work come first, with larger bodies before smaller ones. The others
// follow with decreasing expected work. Results do not depend on it.
void put_longest_first(std::span<std::size_t> indices, std::span<const EvaluationRequest> requests);

// Returns the indices of the requests without a result, sorted in the same way.
std::vector<std::size_t> open_longest_first(
    std::span<const EvaluationRequest> requests,
    std::span<const std::optional<EvaluationResult>> results);

}  // namespace cambrian
