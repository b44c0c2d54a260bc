#pragma once

// What the runs of a comparison say, as text for a person.

#include "comparison/compared_run.h"

#include <string>
#include <vector>

namespace cambrian {

// The finished runs of one arm in one world.
std::vector<ComparedRun> runs_of(const std::vector<ComparedRun>& runs, const std::string& world,
                                 const std::string& arm);
// Names in the order in which they first occur.
std::vector<std::string> worlds_of(const std::vector<ComparedRun>& runs);
std::vector<std::string> arms_of(const std::vector<ComparedRun>& runs);

// A table in Markdown for each world: every arm's median of the confirmed scores, its bootstrap
// interval, the worst run, the ratio to the first arm, whether chance explains that
// (Mann-Whitney), and what else was measured. Last the ratios' geometric means over all worlds.
std::string comparison_report(const std::vector<ComparedRun>& runs);

}  // namespace cambrian
