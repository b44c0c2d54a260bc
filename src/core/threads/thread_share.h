#pragma once

#include "core/threads/thread_priority.h"

#include <cstddef>

namespace cambrian {

// The threads that a part of the program starts for its computations.
struct ThreadShare {
    std::size_t workers = 1;
    ThreadPriority priority = ThreadPriority::kBackground;
};

}  // namespace cambrian
