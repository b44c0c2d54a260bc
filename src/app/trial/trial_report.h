#pragma once

// What one trial came to: the score, how far it can be believed, what it cost.

#include "evolution/individual/individual.h"

#include <string>

namespace cambrian {

// unit: of the goal's score.
std::string trial_text(const EvaluationResult& result, const std::string& unit);  // some lines
std::string trial_json(const EvaluationResult& result, const std::string& unit);  // one object

// "0.41 BL/s, clean"
std::string finer_text(const FinerResult& finer, const std::string& unit);

}  // namespace cambrian
