#include "core/threads/thread_priority.h"

#ifdef __linux__
#include <sys/resource.h>
#endif

namespace cambrian {
namespace {

#ifdef __linux__
constexpr int kBackgroundNiceness = 19;  // the least share there is

// Linux keeps a niceness for every thread; 0 names the calling one. A refusal changes no result.
void step_back() {
    static_cast<void>(setpriority(PRIO_PROCESS, 0, kBackgroundNiceness));
}
#else
void step_back() {}
#endif

}  // namespace

void take_priority(ThreadPriority priority) {
    if (priority == ThreadPriority::kBackground) step_back();
}

}  // namespace cambrian
