#include "core/threads/snapshot_channel.h"

#include "support/catch.h"

#include <algorithm>
#include <memory>
#include <thread>
#include <vector>

using namespace cambrian;

namespace {

struct Pair {
    int first = 0;
    int second = 0;
};

}  // namespace

TEST_CASE("a channel is empty until something is published", "[core][snapshot_channel]") {
    SnapshotChannel<int> channel;
    CHECK(channel.latest() == nullptr);
    channel.publish(std::make_shared<const int>(1));
    REQUIRE(channel.latest() != nullptr);
    CHECK(*channel.latest() == 1);
}

TEST_CASE("the reader sees the newest value and keeps it", "[core][snapshot_channel]") {
    SnapshotChannel<int> channel;
    for (int i = 1; i <= 7; ++i)
        channel.publish(std::make_shared<const int>(i));
    CHECK(*channel.latest() == 7);
    CHECK(*channel.latest() == 7);
}

TEST_CASE("at most three values stay alive", "[core][snapshot_channel]") {
    SnapshotChannel<int> channel;
    std::vector<std::weak_ptr<const int>> published;
    for (int i = 0; i < 10; ++i) {
        const auto value = std::make_shared<const int>(i);
        published.push_back(value);
        channel.publish(value);
        if (i % 3 == 0) channel.latest();
    }
    const auto alive = std::count_if(published.begin(), published.end(),
                                     [](const auto& value) { return !value.expired(); });
    CHECK(alive <= 3);
}

TEST_CASE("a reader beside a writer sees complete values, never older ones",
          "[core][snapshot_channel][threads]") {
    constexpr int kCount = 20000;
    SnapshotChannel<Pair> channel;
    std::jthread writer([&] {
        for (int i = 1; i <= kCount; ++i)
            channel.publish(std::make_shared<const Pair>(Pair{i, -i}));
    });
    bool whole = true;
    bool forward = true;
    int newest = 0;
    while (newest < kCount) {
        const auto& seen = channel.latest();
        if (!seen) continue;
        whole = whole && seen->second == -seen->first;
        forward = forward && seen->first >= newest;
        newest = seen->first;
    }
    CHECK(whole);
    CHECK(forward);
}
