#include "core/threads/worker_inbox.h"

#include "support/catch.h"

#include <atomic>
#include <memory>
#include <stdexcept>
#include <thread>
#include <vector>

using namespace cambrian;

TEST_CASE("commands come out once, in order, also after one that fails", "[core][worker_inbox]") {
    WorkerInbox<int> inbox;
    for (const int command : {1, 2, 3})
        inbox.send(command);
    std::vector<int> seen;
    const auto fail_at_1 = [&](int command) {
        seen.push_back(command);
        if (command == 1) throw std::runtime_error("1");
    };
    CHECK_THROWS(inbox.drain(fail_at_1));
    inbox.work_until_command({}, [](const std::stop_token&) { FAIL("commands wait"); });
    CHECK(inbox.drain(fail_at_1));
    CHECK(seen == std::vector<int>{1, 2, 3});
    CHECK_FALSE(inbox.drain([](int) { FAIL("nothing was sent"); }));
}

TEST_CASE("an inbox keeps no command that was taken", "[core][worker_inbox]") {
    WorkerInbox<std::shared_ptr<int>> inbox;
    const auto command = std::make_shared<int>(1);
    inbox.send(command);
    inbox.drain([](const std::shared_ptr<int>&) {});
    CHECK(command.use_count() == 1);
}

TEST_CASE("no work begins while a command waits", "[core][worker_inbox]") {
    WorkerInbox<int> inbox;
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
    WorkerInbox<int> inbox;
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
    WorkerInbox<int> inbox;
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
    for (int i = 0; i < kCount; ++i)
        inbox.send(1);
    while (sum < kCount)
        std::this_thread::yield();
    CHECK(sum == kCount);
}
