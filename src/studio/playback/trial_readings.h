#pragma once

// Readings recorded while a trial is played: signals, energy and the path of the centre of mass.

#include "math/types.h"
#include "studio/playback/energy_trace.h"
#include "studio/playback/signal_trace.h"

#include <cstdint>
#include <span>
#include <vector>

namespace cambrian {

class Trial;

class TrialReadings {
public:
    void clear();
    // Records the trial's present tick; `outputs` is the number of the network's outputs.
    void add(const Trial& trial, std::size_t outputs);
    // Forgets all signals, and the path after this tick.
    void go_back(std::uint64_t tick);

    const SignalTrace& signals() const { return signals_; }
    const EnergyTrace& energy() const { return energy_; }  // of the test phase
    // Returns the last positions of the centre of mass, in m, oldest first, one every four ticks.
    std::span<const Vec2> trail() const;

private:
    SignalTrace signals_;
    EnergyTrace energy_;
    std::vector<Vec2> dots_;  // all positions since the start
};

}  // namespace cambrian
