#pragma once

// A byte for each tick of a trial, so that of two computations of it the first tick that differs
// can be told.

#include "simulator/trial.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace cambrian {

// Each a byte of the digest of the state after a tick, settling included. One in 256 ticks that
// differ has the same byte; those after it tell.
using TickChecks = std::vector<std::uint8_t>;

inline constexpr auto kTicksASecond = static_cast<std::size_t>(1.0 / kBrainTick + 0.5);
inline constexpr std::size_t kMostTickChecks = 120 * kTicksASecond;  // later ones are not kept

// Notes the tick a trial has just made.
void note_tick(TickChecks& checks, const Trial& trial);

// Runs a trial to its end, noting every tick. False if unwanted() said so before one.
template <class Unwanted>
bool run_noting_ticks(Trial& trial, TickChecks& checks, const Unwanted& unwanted) {
    for (bool more = true; more; note_tick(checks, trial)) {
        if (unwanted()) return false;
        more = trial.tick();
    }
    return true;
}

// The first tick that differs or that only one of them has, counted from 1.
std::optional<std::size_t> first_different_tick(const TickChecks& a, const TickChecks& b);

}  // namespace cambrian
