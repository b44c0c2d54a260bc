#pragma once

// A line on a terminal that tells how far some work is; nothing at all where standard error is not
// a terminal. A thread of its own draws it.

#include "core/stopwatch.h"

#include <functional>
#include <mutex>
#include <string>
#include <thread>

namespace cambrian {

class ProgressLine {
public:
    // text: asked for again and again, never while interrupt() works; what it reads outlives the
    // line.
    explicit ProgressLine(std::function<std::string()> text);
    ~ProgressLine();  // clears the line
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    // Work that writes to the terminal itself or changes what the text reads.
    void interrupt(const std::function<void()>& work);
    double seconds() const { return stopwatch_.seconds(); }

private:
    void draw_until(const std::stop_token& stop);
    void draw() const;
    static void clear();

    const std::function<std::string()> text_;
    const bool shown_;
    Stopwatch stopwatch_;
    std::mutex terminal_;  // one of the two threads writes at a time
    std::jthread thread_;  // last: uses everything above
};

// "[####....] 12 %" of a share from 0 to 1.
std::string bar_text(double share);
// "  0:30 left" of work that has come to the share after so many seconds; empty if it is too early
// to tell.
std::string time_left_text(double share, double seconds);

}  // namespace cambrian
