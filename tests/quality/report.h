#pragma once

// The runs and their criteria as a Markdown page.

#include "quality/criteria.h"

#include <string>
#include <vector>

namespace cambrian::quality {

std::string criteria_table(const std::vector<Criterion>& criteria);
// Returns a table for each goal with every arm of a plan that was run.
std::string arm_tables(const std::vector<RunResult>& runs, std::string_view plan);

}  // namespace cambrian::quality
