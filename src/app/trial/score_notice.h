#pragma once

#include "evolution/engine/experiment_log.h"
#include "persist/creature/creature_file.h"

#include <string>

namespace cambrian {

// A message on standard error if another version of the simulator scored the file's creatures.
void say_of_simulator(const std::string& file, const CreatureDocument& document);
void say_of_simulator(const std::string& file, const SavedExperiment& saved);

}  // namespace cambrian
