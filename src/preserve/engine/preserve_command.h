#pragma once

#include "preserve/chronicle.h"
#include "preserve/pins.h"

#include <cstdint>
#include <variant>

namespace cambrian {

// Commands to a preserve on its thread, as plain values. They take effect between two ticks.
struct PlayPreserve {
    bool playing = true;
};
struct StepPreserve {};  // one tick, then pause
struct PacePreserve {
    double factor = 1.0;  // of real time, above 0; kFullSpeed for as fast as it goes
};
inline constexpr double kFullSpeed = 0.0;
struct Intervene {
    Intervention intervention;  // its tick is ignored
};

// Lets the log keep these pins, from when it is written next.
struct KeepPins {
    Pins pins;
};

// Puts the brain of one creature into the pictures from now on.
struct WatchBrain {
    std::uint64_t creature = 0;  // number; 0 for none
};

using PreserveCommand =
    std::variant<PlayPreserve, StepPreserve, PacePreserve, Intervene, KeepPins, WatchBrain>;

}  // namespace cambrian
