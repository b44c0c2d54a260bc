#pragma once

#include "core/result.h"

namespace cambrian {

// Prepares the process: opens missing standard streams, turns failed writes into errors instead of
// signals, and provides a large stack. Fails if the system does not allow such a stack.
Status prepare_process();

}  // namespace cambrian
