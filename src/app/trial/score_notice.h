#pragma once

#include "evolution/engine/experiment_log.h"
#include "persist/creature/creature_file.h"

#include <string>

namespace cambrian {

// Prints a message to standard error if the file's creatures were scored by another version of the
// simulator.
void say_of_simulator(const std::string& file, const CreatureDocument& document);
void say_of_simulator(const std::string& file, const SavedExperiment& saved);

}  // namespace cambrian
