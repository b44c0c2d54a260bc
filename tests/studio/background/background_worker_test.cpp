#include "studio/background/background_worker.h"

#include "support/catch.h"

#include <atomic>
#include <thread>
#include <vector>

namespace cambrian {
namespace {

void deliver_all(BackgroundWorker& worker) {
    while (!worker.idle()) {
        worker.deliver();
        std::this_thread::yield();
    }
}

TEST_CASE("jobs run on the worker's thread and completions on the caller's, in order",
          "[studio][background_worker][threads]") {
    BackgroundWorker worker;
    const auto here = std::this_thread::get_id();
    std::vector<int> completed;
    std::atomic<int> elsewhere = 0;
    for (int i = 0; i < 300; ++i) {
        worker.submit([&, i](const std::stop_token&) {
            if (std::this_thread::get_id() != here) ++elsewhere;
            return [&completed, i] { completed.push_back(i); };
        });
    }
    deliver_all(worker);
    CHECK(elsewhere == 300);
    REQUIRE(completed.size() == 300);
    for (int i = 0; i < 300; ++i)
        REQUIRE(completed[static_cast<std::size_t>(i)] == i);
}

TEST_CASE("closing the worker finishes every submitted job",
          "[studio][background_worker][threads]") {
    std::atomic<int> done = 0;
    {
        BackgroundWorker worker;
        for (int i = 0; i < 200; ++i) {
            worker.submit([&done](const std::stop_token&) {
                ++done;
                return [] {};
            });
        }
    }
    CHECK(done == 200);
}

TEST_CASE("closing the worker tells a long job to stop", "[studio][background_worker][threads]") {
    std::atomic<bool> stopped = false;
    {
        BackgroundWorker worker;
        worker.submit([&stopped](const std::stop_token& stop) {
            while (!stop.stop_requested())
                std::this_thread::yield();
            stopped = true;
            return [] {};
        });
    }
    CHECK(stopped);
}

}  // namespace
}  // namespace cambrian
