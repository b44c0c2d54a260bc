#pragma once

// What a creature loses without its senses, as text.

#include "evolution/evaluation/sense_losses.h"

#include <string>

namespace cambrian {

// A line for all senses, then one for each, the greatest loss first.
std::string senses_text(const SenseLosses& losses, const std::string& unit);
std::string senses_json(const SenseLosses& losses);  // one JSON object

}  // namespace cambrian
