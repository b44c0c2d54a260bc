#pragma once

#include "core/result.h"

namespace cambrian {

// What this process needs of the system before it does anything: standard streams that are open,
// failures to write as errors and not as signals, and a stack that is large enough. Fails, saying
// so, if there is no such stack to be had.
Status prepare_process();

}  // namespace cambrian
