#pragma once

#include "world/environment.h"

namespace cambrian {

// The slowest fall of any body that does nothing, m/s: that of the thinnest part there is, flat
// across its way, whose drag carries its weight. 0 without gravity or drag.
double passive_sink(const Environment& environment);

}  // namespace cambrian
