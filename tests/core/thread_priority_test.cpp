#include "core/threads/thread_priority.h"

#include "core/threads/thread_pool.h"
#include "support/catch.h"

#ifdef __linux__

#include <algorithm>
#include <sys/resource.h>
#include <thread>
#include <vector>

namespace cambrian {
namespace {

int niceness() {
    return getpriority(PRIO_PROCESS, 0);
}

TEST_CASE("a thread in the background steps back, and only it", "[core][thread_priority]") {
    const int before = niceness();
    int normal = 0;
    int serving = 0;
    int background = 0;
    std::jthread([&] {
        take_priority(ThreadPriority::kNormal);
        normal = niceness();
        take_priority(ThreadPriority::kServing);
        serving = niceness();
        take_priority(ThreadPriority::kBackground);
        background = niceness();
    }).join();
    CHECK(normal == before);
    CHECK(serving == std::max(before, 10));
    CHECK(background == 19);
    CHECK(niceness() == before);
}

TEST_CASE("all threads of a pool have its priority, the calling one too",
          "[core][thread_priority]") {
    std::vector<int> seen(100);
    std::jthread([&seen] {
        ThreadPool pool(3, ThreadPriority::kBackground);
        pool.parallel_for(seen.size(),
                          [&](std::size_t index, std::size_t) { seen[index] = niceness(); });
    }).join();
    CHECK(seen == std::vector<int>(100, 19));
}

}  // namespace
}  // namespace cambrian

#endif
