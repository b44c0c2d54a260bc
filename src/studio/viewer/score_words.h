#pragma once

// Descriptions of scores.

#include "evolution/individual/individual.h"

#include <string>

namespace cambrian {

// Returns the range of a confirmed creature's scores, as in "0.81 to 0.99 in 3 worlds"; empty for a
// creature that is not confirmed.
std::string confirmed_range(const EvaluationResult& result);

}  // namespace cambrian
