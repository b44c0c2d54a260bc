#pragma once

#include "core/threads/thread_priority.h"

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name
class App;
}

namespace cambrian {

// Adds `--priority background|normal`, the priority of a program's computations beside other
// programs. `priority` is kBackground unless it is given.
void add_priority(CLI::App& app, ThreadPriority& priority);

}  // namespace cambrian
