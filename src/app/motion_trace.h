#pragma once

// The motion of one trial as a table (CSV): a row a tick of 1/60 s, from the beginning of the test
// to its end.

#include "simulator/trial.h"

#include <string>

namespace cambrian {

// Columns: time (s), centre of mass (m), then for every part its centre (m), its angle (rad) and
// its joint's coordinate (rad or m).
class MotionTrace {
public:
    explicit MotionTrace(const Trial& trial);
    // Appends the present moment.
    void add(const Trial& trial);
    const std::string& csv() const { return csv_; }

private:
    std::string csv_;
};

}  // namespace cambrian
