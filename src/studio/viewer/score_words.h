#pragma once

// Scores in words.

#include "evolution/individual/individual.h"

#include <string>

namespace cambrian {

// "0.81 to 0.99 in 3 worlds", the range of a confirmed creature's scores; empty of another.
std::string confirmed_range(const EvaluationResult& result);

}  // namespace cambrian
