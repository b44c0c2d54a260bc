#include "core/threads/command_queue.h"

#include "support/catch.h"

#include <memory>
#include <thread>

using namespace cambrian;

TEST_CASE("values come out of the queue in the order they went in", "[core][command_queue]") {
    CommandQueue<int, 4> queue;
    CHECK_FALSE(queue.pop());
    for (int round = 0; round < 10; ++round) {
        CHECK(queue.push(2 * round));
        CHECK(queue.push(2 * round + 1));
        CHECK(queue.pop() == 2 * round);
        CHECK(queue.pop() == 2 * round + 1);
    }
}

TEST_CASE("a full queue refuses and leaves the value untouched", "[core][command_queue]") {
    CommandQueue<std::unique_ptr<int>, 2> queue;
    CHECK(queue.push(std::make_unique<int>(1)));
    CHECK(queue.push(std::make_unique<int>(2)));
    auto third = std::make_unique<int>(3);
    CHECK_FALSE(queue.push(std::move(third)));
    REQUIRE(third != nullptr);  // NOLINT(bugprone-use-after-move): refusing must not move
    CHECK(*queue.pop().value() == 1);
    CHECK(queue.push(std::move(third)));
}

TEST_CASE("a popped value is not kept alive by the queue", "[core][command_queue]") {
    CommandQueue<std::shared_ptr<int>, 2> queue;
    const auto value = std::make_shared<int>(5);
    queue.push(std::shared_ptr<int>(value));
    queue.pop();
    CHECK(value.use_count() == 1);
}

TEST_CASE("nothing is lost or reordered between two threads", "[core][command_queue][threads]") {
    constexpr int kCount = 20000;
    CommandQueue<std::shared_ptr<int>, 16> queue;
    std::jthread producer([&] {
        for (int i = 0; i < kCount; ++i) {
            auto value = std::make_shared<int>(i);
            while (!queue.push(std::move(value)))
                std::this_thread::yield();
        }
    });
    bool ordered = true;
    for (int expected = 0; expected < kCount;) {
        const auto value = queue.pop();
        if (!value) {
            std::this_thread::yield();
            continue;
        }
        ordered = ordered && **value == expected;
        ++expected;
    }
    CHECK(ordered);
    CHECK_FALSE(queue.pop());
}
