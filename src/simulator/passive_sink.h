#pragma once

#include "world/environment.h"

namespace cambrian {

// Returns the slowest steady sink speed of a passive body, m/s. The thinnest allowed part has it
// when it falls broadside and its drag equals its weight. 0 without gravity or drag.
double passive_sink(const Environment& environment);

}  // namespace cambrian
