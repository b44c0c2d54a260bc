#pragma once

namespace cambrian {

// A thread's share of a busy processor. It never changes a result.
enum class ThreadPriority {
    kNormal,
    kServing,     // yields to normal threads, but not to those in the background
    kBackground,  // yields to all others
};

// Lowers the priority of the calling thread and of threads that it starts later; it cannot be
// raised again. Has no effect on systems without priorities for threads.
void take_priority(ThreadPriority priority);

}  // namespace cambrian
