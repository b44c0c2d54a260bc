#pragma once

#include "persist/creature_file.h"

#include <string>

namespace cambrian {

// A message on standard error if another version of the simulator scored the file's creature.
void say_of_simulator(const std::string& file, const CreatureDocument& document);

}  // namespace cambrian
