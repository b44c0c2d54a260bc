#pragma once

// When the next tick of a preserve is due, and how fast it goes. The clock decides only when a tick
// is computed, never its result.

#include "core/stopwatch.h"

#include <cstdint>
#include <stop_token>

namespace cambrian {

class Pacing {
public:
    // `factor` of real time; 0 means that every tick is due at once.
    void set(double factor);
    double factor() const { return factor_; }
    // Forgets the past, for a preserve that was paused.
    void begin();
    // Waits until the next tick is due; returns false if a stop was requested.
    bool wait(const std::stop_token& stop) const;
    // Counts a tick. One that comes much too late is not made up for.
    void count();
    // The speed reached lately, as a factor of real time.
    double reached() const { return reached_; }

private:
    double due() const;  // s from now; below 0 if late

    double factor_ = 1.0;
    Stopwatch begun_;
    std::uint64_t ticks_ = 0;  // since begun_
    Stopwatch measured_;
    std::uint64_t measured_ticks_ = 0;
    double reached_ = 0.0;
};

}  // namespace cambrian
