#pragma once

// The result of a comparison as text.

#include "comparison/compared_run.h"

#include <string>
#include <vector>

namespace cambrian {

// Name of the file of the report in the folder of a comparison.
inline constexpr const char* kReportFile = "report.md";

// Returns the finished runs of one arm in one world.
std::vector<ComparedRun> runs_of(const std::vector<ComparedRun>& runs, const std::string& world,
                                 const std::string& arm);
// Return the names in order of first occurrence.
std::vector<std::string> worlds_of(const std::vector<ComparedRun>& runs);
std::vector<std::string> arms_of(const std::vector<ComparedRun>& runs);

// Returns a Markdown table for each world. For every arm it has the median of the confirmed scores
// with its bootstrap interval, the worst run, and the ratio to the first arm with its p-value
// (Mann-Whitney). Further columns have the other measurements. A list at the end has the geometric
// means of the ratios over all worlds.
std::string comparison_report(const std::vector<ComparedRun>& runs);

}  // namespace cambrian
