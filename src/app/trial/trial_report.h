#pragma once

// The result of one trial as text: the score, the verdict of the energy audit, the computing work.

#include "evolution/individual/individual.h"

#include <string>

namespace cambrian {

// `unit` is the unit of the goal's score.
std::string trial_text(const EvaluationResult& result, const std::string& unit);  // several lines
// One JSON object; `senses` is its value of that name (sense_report.h).
std::string trial_json(const EvaluationResult& result, const std::string& unit,
                       const std::string& senses = "null");

// Example: "0.41 BL/s, clean".
std::string finer_text(const FinerResult& finer, const std::string& unit);

}  // namespace cambrian
