#include "core/threads/thread_pool.h"

#include "support/catch.h"

#include <algorithm>
#include <atomic>
#include <stdexcept>

using namespace cambrian;

TEST_CASE("every index is worked on exactly once", "[core][thread_pool][threads]") {
    for (const std::size_t workers : {1U, 2U, 7U}) {
        ThreadPool pool(workers);
        REQUIRE(pool.workers() == workers);
        for (const std::size_t count : {0U, 1U, 3U, 1000U}) {
            std::vector<int> visits(count);
            const bool complete =
                pool.parallel_for(count, [&](std::size_t index, std::size_t) { ++visits[index]; });
            REQUIRE(complete);
            REQUIRE(std::count(visits.begin(), visits.end(), 1) ==
                    static_cast<std::ptrdiff_t>(count));
        }
    }
}

TEST_CASE("a worker's number is its own while it works", "[core][thread_pool][threads]") {
    ThreadPool pool(4);
    // Unguarded on purpose, so that the thread sanitizer detects sharing.
    std::vector<std::size_t> scratch(pool.workers());
    pool.parallel_for(5000, [&](std::size_t, std::size_t worker) { ++scratch[worker]; });
    CHECK(scratch[0] + scratch[1] + scratch[2] + scratch[3] == 5000);
}

TEST_CASE("a pool serves many ranges one after the other", "[core][thread_pool][threads]") {
    ThreadPool pool(3);
    std::atomic<int> sum = 0;
    for (int round = 0; round < 500; ++round)
        REQUIRE(pool.parallel_for(5, [&](std::size_t, std::size_t) { ++sum; }));
    CHECK(sum == 2500);
}

TEST_CASE("a stop request begins no further index and says so", "[core][thread_pool][threads]") {
    ThreadPool pool(2);
    std::stop_source source;
    std::atomic<int> begun = 0;
    const auto work = [&](std::size_t, std::size_t) {
        if (++begun == 10) source.request_stop();
    };
    CHECK_FALSE(pool.parallel_for(100000, work, source.get_token()));
    CHECK(begun < 100000);
    CHECK_FALSE(pool.parallel_for(5, work, source.get_token()));
    CHECK(pool.parallel_for(5, work));
}

TEST_CASE("an exception of the work reaches the caller and the pool lives on",
          "[core][thread_pool][threads]") {
    ThreadPool pool(2);
    const auto failing = [](std::size_t index, std::size_t) {
        if (index == 3) throw std::runtime_error("third");
    };
    CHECK_THROWS_WITH(pool.parallel_for(10, failing), "third");
    std::atomic<int> done = 0;
    CHECK(pool.parallel_for(10, [&](std::size_t, std::size_t) { ++done; }));
    CHECK(done == 10);
}
