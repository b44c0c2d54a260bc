#pragma once

// A progress line on the terminal, drawn by its own thread. Prints nothing if standard error is not
// a terminal.

#include "core/stopwatch.h"

#include <functional>
#include <mutex>
#include <string>
#include <thread>

namespace cambrian {

class ProgressLine {
public:
    // `text` is called repeatedly, never while interrupt() works. What it reads must outlive the
    // object.
    explicit ProgressLine(std::function<std::string()> text);
    ~ProgressLine();  // clears the line
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    // Runs `work`, which may write to the terminal and change what `text` reads.
    void interrupt(const std::function<void()>& work);
    double seconds() const { return stopwatch_.seconds(); }

private:
    void draw_until(const std::stop_token& stop);
    void draw() const;
    static void clear();

    const std::function<std::string()> text_;
    const bool shown_;
    Stopwatch stopwatch_;
    std::mutex terminal_;  // held by the thread that writes to the terminal
    std::jthread thread_;  // last member, since it uses the others
};

// Returns "[####....] 12 %" for a share in [0, 1].
std::string bar_text(double share);
// Returns "  0:30 left" for work of which `share` took so many seconds; empty if it is too early to
// estimate.
std::string time_left_text(double share, double seconds);

}  // namespace cambrian
