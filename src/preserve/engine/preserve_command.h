#pragma once

#include "preserve/chronicle.h"
#include "preserve/pins.h"

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
// Takes a snapshot and writes everything to the log.
struct KeepPreserve {};

// Lets the log keep these pins, from when it is written next.
struct KeepPins {
    Pins pins;
};

using PreserveCommand =
    std::variant<PlayPreserve, StepPreserve, PacePreserve, Intervene, KeepPreserve, KeepPins>;

}  // namespace cambrian
