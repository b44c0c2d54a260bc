#pragma once

// Readings recorded while a trial is played: signals, energy and the path of the centre of mass.

#include "math/types.h"
#include "pictures/motion/scuffs.h"
#include "studio/playback/energy_trace.h"
#include "studio/playback/signal_trace.h"

#include <cstdint>
#include <span>
#include <vector>

namespace cambrian {

class Trial;

class TrialReadings {
public:
    // Forgets all but the posture; `trial` is at its start.
    void begin(const Trial& trial);
    // Records the trial's present tick; `outputs` is the number of the network's outputs.
    void add(const Trial& trial, std::size_t outputs);
    // Forgets all signals, and the path and scuffs after the trial's present tick.
    void go_back(const Trial& trial);

    const SignalTrace& signals() const { return signals_; }
    const EnergyTrace& energy() const { return energy_; }  // of the test phase
    // Returns the last positions of the centre of mass in the test, in m, oldest first, one every
    // four ticks.
    std::span<const Vec2> trail() const;
    std::span<const Vec3> trail_in_space() const;  // the same
    // Returns the parts' poses at the start of the test; empty until it was reached once.
    std::span<const Pose> posture() const { return posture_; }
    std::span<const Scuff> scuffs() const { return scuffs_; }  // of the test

private:
    void remember_body(const Trial& trial);

    SignalTrace signals_;
    EnergyTrace energy_;
    std::vector<Vec2> dots_;  // all positions since the start of the test
    std::vector<Vec3> dots_in_space_;
    std::vector<Scuff> scuffs_;
    std::vector<Pose> posture_;
    std::vector<Pose> poses_;  // at the tick before
    std::vector<double> stretches_;
};

}  // namespace cambrian
