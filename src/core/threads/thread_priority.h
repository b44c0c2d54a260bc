#pragma once

namespace cambrian {

// A thread's share of a busy processor. It never changes a result.
enum class ThreadPriority {
    kNormal,
    kBackground,  // yields to every normal thread
};

// Sets the priority of the calling thread and of threads that it starts later. A background thread
// cannot become normal again. Has no effect on systems without priorities for threads.
void take_priority(ThreadPriority priority);

}  // namespace cambrian
