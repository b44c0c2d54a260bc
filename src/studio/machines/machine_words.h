#pragma once

// Descriptions of machines and clusters.

#include "evolution/evaluation/backend_status.h"
#include "studio/machines/machines_contract.h"

#include <string>

namespace cambrian {

// Examples: "working", "idle", "away 12 s", "refused: other bits".
std::string state_words(const WorkerStatus& worker);
// Example: "14 machines · 112 cores · 9 800 creatures/s".
std::string totals_words(const BackendStatus& status);
// Example: "This run can use about 40 cores"; empty while unknown.
std::string useful_cores_words(const BackendStatus& status);
// Returns the text of the line at the bottom of the window. Problems come first.
std::string machines_words(const MachinesView& machines);
// Returns whether that text names a problem that the user may have to solve.
bool troubled(const MachinesView& machines);

}  // namespace cambrian
