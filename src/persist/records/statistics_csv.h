#pragma once

// A run's statistics as comma-separated values, for spreadsheets and scripts.

#include "evolution/individual/statistics.h"

#include <span>
#include <string>

namespace cambrian {

// Returns a header row that names every field of GenerationStatistics, then one row per generation.
// One more column has the number of trials since the start. Numbers read back to the same bits;
// flags are 1 and 0.
std::string statistics_csv(std::span<const GenerationStatistics> history);

}  // namespace cambrian
