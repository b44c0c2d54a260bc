#pragma once

#include "studio/comparison/comparison_results.h"

#include <string>

namespace cambrian {

// Draws the median and the quartiles of every arm over the trials in the next `height` pixels of
// the window, with the values under the mouse as a tooltip.
void draw_comparison_chart(const ComparisonResults& results, const std::string& unit, float height);

}  // namespace cambrian
