#pragma once

#include "core/stopwatch.h"

#include <filesystem>
#include <fstream>

namespace cambrian {

// Times of every frame as CSV: when it began, how long the last one took from start to start, and
// how long this one took to prepare (without waiting for the display); milliseconds but the first.
class FrameLog {
public:
    explicit FrameLog(const std::filesystem::path& path) {
        if (path.empty()) return;
        file_.open(path);
        file_ << "time_s,interval_ms,work_ms,playback_ms\n";
    }
    void write(double interval, double work, double playback) {
        if (!file_.is_open()) return;
        file_ << since_start_.seconds() << ',' << 1e3 * interval << ',' << 1e3 * work << ','
              << 1e3 * playback << '\n';
    }

private:
    std::ofstream file_;
    Stopwatch since_start_;
};

}  // namespace cambrian
