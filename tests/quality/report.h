#pragma once

// The runs and what they say as a page of Markdown.

#include "quality/criteria.h"

#include <string>
#include <vector>

namespace cambrian::quality {

std::string criteria_table(const std::vector<Criterion>& criteria);
// Every arm of every goal of a plan that was run.
std::string arm_tables(const std::vector<RunResult>& runs, std::string_view plan);

}  // namespace cambrian::quality
