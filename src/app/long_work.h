#pragma once

// Trials that a command computes and that may take minutes: a line on a terminal tells how far
// they are, the first Ctrl+C asks them to stop.

#include "app/interruption.h"
#include "app/progress_line.h"
#include "simulator/trial_watch.h"

#include <atomic>
#include <string>

namespace cambrian {

class LongWork {
public:
    LongWork() : line_([this] { return text(); }) {}

    // What is done from now on, and how much of it: seconds of motion unless another unit is
    // named. What tells through watch() how far it is, is shown as a share.
    void begin(const std::string& stage, double length, const std::string& unit = "s");
    TrialWatch watch() { return {.stop = interruption_.token(), .time = &time_}; }
    std::stop_token stop() const { return interruption_.token(); }
    bool interrupted() const { return interruption_.requested(); }

private:
    std::string text() const;

    Interruption interruption_;
    std::string stage_;  // changed while the line is interrupted, with what follows
    std::string unit_;
    double length_ = 0.0;
    double began_ = 0.0;  // s on the line's clock
    std::atomic<double> time_ = 0.0;
    ProgressLine line_;  // last: asks for the text
};

}  // namespace cambrian
