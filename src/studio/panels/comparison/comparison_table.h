#pragma once

#include "studio/comparison/comparison_results.h"
#include "studio/frame/requests.h"

#include <string>

namespace cambrian {

// Draws a row for each arm: its runs, its median score in that unit, how it compares with the
// first arm, and a button that shows its best champion.
void draw_comparison_table(const ComparisonResults& results, const std::string& unit,
                           Requests& out);

}  // namespace cambrian
