#pragma once

// Machines and clusters in words.

#include "evolution/evaluation/backend_status.h"
#include "studio/machines/machines_contract.h"

#include <string>

namespace cambrian {

// "working", "idle", "away 12 s", "refused: other bits".
std::string state_words(const WorkerStatus& worker);
// "14 machines · 112 cores · 9 800 creatures/s".
std::string totals_words(const BackendStatus& status);
// "This run can use about 40 cores"; empty while unknown.
std::string useful_cores_words(const BackendStatus& status);
// The text of the line under the panels; problems come first.
std::string machines_words(const MachinesView& machines);
// Whether that text has a problem that a person may have to solve.
bool troubled(const MachinesView& machines);

}  // namespace cambrian
