#pragma once

// The interventions of people between two ticks (preserve/README.md 8).

#include "preserve/population.h"

namespace cambrian {

// Does all that people may ask for but rest. Returns the number that goes into the record: of the
// creature, of plants or of walls. Fails if it cannot be done; nothing changes then.
Result<std::uint64_t> carry_out(const Intervention& asked, PreserveWorld& world,
                                Population& population);

}  // namespace cambrian
