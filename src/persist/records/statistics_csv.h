#pragma once

// A run's statistics as comma-separated values, for spreadsheets and scripts.

#include "evolution/individual/statistics.h"

#include <span>
#include <string>

namespace cambrian {

// A header row that names every field of GenerationStatistics, then a row a generation; beside the
// fields the trials run since the beginning. Numbers read back to the same bits; yes and no are 1
// and 0.
std::string statistics_csv(std::span<const GenerationStatistics> history);

}  // namespace cambrian
