#include "core/threads/thread_priority.h"

#ifdef __linux__
#include <sched.h>
#include <sys/resource.h>
#endif

namespace cambrian {
namespace {

#ifdef __linux__
constexpr int kServingNiceness = 10;     // a tenth of a normal thread's share
constexpr int kBackgroundNiceness = 19;  // lowest priority

// On Linux every thread has a niceness and a scheduling policy; 0 means the calling thread. The
// idle policy yields at once, whereas niceness alone takes effect at the end of a time slice. A
// failure has no influence on results.
void be_as_nice_as(int niceness) {
    if (getpriority(PRIO_PROCESS, 0) < niceness)
        static_cast<void>(setpriority(PRIO_PROCESS, 0, niceness));
}

void step_back() {
    be_as_nice_as(kBackgroundNiceness);
    const sched_param no_priority{};
    static_cast<void>(sched_setscheduler(0, SCHED_IDLE, &no_priority));
}
#else
constexpr int kServingNiceness = 0;
void be_as_nice_as(int) {}
void step_back() {}
#endif

}  // namespace

void take_priority(ThreadPriority priority) {
    if (priority == ThreadPriority::kServing) be_as_nice_as(kServingNiceness);
    if (priority == ThreadPriority::kBackground) step_back();
}

}  // namespace cambrian
