#pragma once

#include "app/process/exit_status.h"
#include "app/process/long_work.h"
#include "evolution/kinds/evolution_kinds.h"

#include <string>

namespace cambrian {

// Computes a preserve file again, from each of its snapshots to the next, and compares digests.
ExitStatus verify_preserve(const std::string& file, const EvolutionKinds& kinds, LongWork& work);

}  // namespace cambrian
