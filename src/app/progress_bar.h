#pragma once

// A line on a terminal that fills while work is done; nothing at all where standard error is not a
// terminal. Draws from a thread of its own, which only reads the counters it is given.

#include "core/stopwatch.h"
#include "evolution/evaluation_backend.h"

#include <atomic>
#include <cstdint>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>

namespace cambrian {

class ProgressBar {
public:
    // progress counts the trials of one generation and must outlive the bar.
    ProgressBar(const EvaluationProgress& progress, std::uint32_t generations);
    ~ProgressBar();  // clears the line
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    // A generation is complete: prints its line above the bar.
    void finish_generation(std::string_view line);

private:
    void draw_until(const std::stop_token& stop);
    void draw();
    void clear();
    std::string text() const;

    const EvaluationProgress& progress_;
    const std::uint32_t generations_;
    const bool shown_;
    Stopwatch stopwatch_;
    std::mutex terminal_;            // one of the two threads writes at a time
    std::uint32_t finished_ = 0;     // generations; guarded by terminal_
    std::uint64_t trials_done_ = 0;  // of finished generations; guarded by terminal_
    std::jthread thread_;            // last: uses everything above
};

}  // namespace cambrian
