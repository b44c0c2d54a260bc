#pragma once

// Trials that a command computes and that may take minutes. A line on the terminal shows the
// progress; the first Ctrl+C requests a stop.

#include "app/process/interruption.h"
#include "app/process/progress_line.h"
#include "simulator/trial_watch.h"

#include <atomic>
#include <string>

namespace cambrian {

class LongWork {
public:
    LongWork() : line_([this] { return text(); }) {}

    // Begins a stage of the work; `length` is its amount, in seconds of motion unless `unit` is
    // another. Progress that is reported through watch() is shown as a percentage.
    void begin(const std::string& stage, double length, const std::string& unit = "s");
    TrialWatch watch() { return {.stop = interruption_.token(), .time = &time_}; }
    std::stop_token stop() const { return interruption_.token(); }
    bool interrupted() const { return interruption_.requested(); }

private:
    std::string text() const;

    Interruption interruption_;
    std::string stage_;  // this and the following members change only while the line is interrupted
    std::string unit_;
    double length_ = 0.0;
    double began_ = 0.0;  // s on the line's clock
    std::atomic<double> time_ = 0.0;
    ProgressLine line_;  // last member, since it reads the others
};

}  // namespace cambrian
