#pragma once

// A check byte for each tick of a trial, by which two computations can be compared to find the
// first tick that differs.

#include "simulator/trial.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace cambrian {

// Each byte is part of the digest of the state after a tick, settling included. One in 256 ticks
// that differ has the same byte by chance; later ticks then differ.
using TickChecks = std::vector<std::uint8_t>;

inline constexpr auto kTicksASecond = static_cast<std::size_t>(1.0 / kBrainTick + 0.5);
inline constexpr std::size_t kMostTickChecks = 120 * kTicksASecond;  // later ticks are not recorded

// Records the last tick of a trial.
void note_tick(TickChecks& checks, const Trial& trial);

// Runs a trial to its end and records every tick. Returns false if unwanted() returned true before
// a tick.
template <class Unwanted>
bool run_noting_ticks(Trial& trial, TickChecks& checks, const Unwanted& unwanted) {
    for (bool more = true; more; note_tick(checks, trial)) {
        if (unwanted()) return false;
        more = trial.tick();
    }
    return true;
}

// Returns the first tick that differs or that only one of them has, counted from 1.
std::optional<std::size_t> first_different_tick(const TickChecks& a, const TickChecks& b);

}  // namespace cambrian
