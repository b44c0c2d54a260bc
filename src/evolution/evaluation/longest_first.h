#pragma once

#include "evolution/evaluation/evaluation.h"

#include <cstddef>
#include <span>
#include <vector>

namespace cambrian {

// Sorts indices of requests so that the longest evaluations start first and no core waits long at
// the end. Requests of unknown work come first, larger bodies before smaller ones; the others
// follow by falling expected work. No result depends on it.
void put_longest_first(std::span<std::size_t> indices, std::span<const EvaluationRequest> requests);

}  // namespace cambrian
