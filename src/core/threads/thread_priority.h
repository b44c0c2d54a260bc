#pragma once

namespace cambrian {

// How a thread shares a busy processor. Never changes a result.
enum class ThreadPriority {
    kNormal,
    kBackground,  // steps back whenever a normal thread has something to do
};

// The calling thread's from now on; threads it starts later begin with it. A thread in the
// background stays there. Does nothing on systems without priorities of single threads.
void take_priority(ThreadPriority priority);

}  // namespace cambrian
