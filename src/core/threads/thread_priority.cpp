#include "core/threads/thread_priority.h"

#ifdef __linux__
#include <sched.h>
#include <sys/resource.h>
#endif

namespace cambrian {
namespace {

#ifdef __linux__
constexpr int kBackgroundNiceness = 19;  // the least share there is

// Linux keeps a niceness and a policy for every thread; 0 names the calling one. The idle policy
// gives way at once, where niceness alone waits for the end of a time slice. A refusal changes no
// result.
void step_back() {
    static_cast<void>(setpriority(PRIO_PROCESS, 0, kBackgroundNiceness));
    const sched_param no_priority{};
    static_cast<void>(sched_setscheduler(0, SCHED_IDLE, &no_priority));
}
#else
void step_back() {}
#endif

}  // namespace

void take_priority(ThreadPriority priority) {
    if (priority == ThreadPriority::kBackground) step_back();
}

}  // namespace cambrian
