#pragma once

#include "evolution/evaluation/evaluation.h"

#include <cstddef>
#include <span>
#include <vector>

namespace cambrian {

// Sorts indices of requests so that what may take longest is begun first and no core waits long for
// another at the end: first those of unknown work, larger bodies before smaller ones, then those of
// the most work expected. Changes no result.
void put_longest_first(std::span<std::size_t> indices, std::span<const EvaluationRequest> requests);

}  // namespace cambrian
