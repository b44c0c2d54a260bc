#pragma once

// Waiting for what an engine's thread publishes.

#include <catch2/catch.hpp>

#include <chrono>
#include <thread>
#include <type_traits>

namespace cambrian::test {

// Waits up to five minutes for a snapshot of the engine that satisfies the condition. A busy
// machine is slow, above all for engines that yield to other programs.
template <class Engine, class Condition>
auto wait_for(Engine& engine, Condition condition) {
    for (int i = 0; i < 300000; ++i) {
        auto snapshot = engine.latest();
        if (condition(*snapshot)) return snapshot;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    FAIL("the engine never got there");
    return std::decay_t<decltype(engine.latest())>();
}

}  // namespace cambrian::test
