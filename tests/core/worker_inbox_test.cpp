#include "core/threads/worker_inbox.h"

#include "support/catch.h"

#include <atomic>
#include <thread>
#include <vector>

using namespace cambrian;

TEST_CASE("a full inbox refuses, and commands come out in order", "[core][worker_inbox]") {
    WorkerInbox<int, 2> inbox;
    CHECK(inbox.send(1));
    CHECK(inbox.send(2));
    CHECK_FALSE(inbox.send(3));
    std::vector<int> seen;
    CHECK(inbox.drain([&](int command) { seen.push_back(command); }));
    CHECK(seen == std::vector<int>{1, 2});
    CHECK_FALSE(inbox.drain([](int) { FAIL("nothing was sent"); }));
}

TEST_CASE("no work begins while a command waits", "[core][worker_inbox]") {
    WorkerInbox<int, 2> inbox;
    inbox.send(1);
    inbox.work_until_command({}, [](const std::stop_token&) { FAIL("a command waits"); });
    inbox.drain([](int) {});
    bool worked = false;
    inbox.work_until_command({}, [&](const std::stop_token& interrupted) {
        worked = true;
        CHECK_FALSE(interrupted.stop_requested());
        inbox.send(2);
        CHECK(interrupted.stop_requested());
    });
    CHECK(worked);
}

TEST_CASE("a stop interrupts work and ends sleep", "[core][worker_inbox]") {
    WorkerInbox<int, 2> inbox;
    std::stop_source stop;
    inbox.work_until_command(stop.get_token(), [&](const std::stop_token& interrupted) {
        stop.request_stop();
        CHECK(interrupted.stop_requested());
    });
    inbox.wait(stop.get_token());
    SUCCEED("wait returned");
}

TEST_CASE("a sleeping or working thread gets every command", "[core][worker_inbox][threads]") {
    constexpr int kCount = 2000;
    WorkerInbox<int, 8> inbox;
    std::atomic<int> sum = 0;
    std::jthread worker([&](const std::stop_token& stop) {
        while (!stop.stop_requested()) {
            inbox.drain([&](int command) { sum += command; });
            if (sum % 2 == 0) inbox.wait(stop);
            inbox.work_until_command(stop, [](const std::stop_token& interrupted) {
                for (int i = 0; i < 1000 && !interrupted.stop_requested(); ++i)
                    std::this_thread::yield();
            });
        }
    });
    for (int i = 0; i < kCount; ++i) {
        while (!inbox.send(1))
            std::this_thread::yield();
    }
    while (sum < kCount)
        std::this_thread::yield();
    CHECK(sum == kCount);
}
