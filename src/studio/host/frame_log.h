#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <fstream>

namespace cambrian {

// The times of one frame, in s.
struct FrameTimes {
    double interval = 0.0;  // from the start of the frame before to the start of this one
    double work = 0.0;      // preparing the frame, without waiting for the display
    double playback = 0.0;  // the part of `work` spent on the motion of creatures
};

// Writes the times of every frame as CSV, flushed at once, so that a reader knows when a frame has
// ended. Columns are the frame's number, counted from 1 as in the status log, its start and its
// hand-over to the display (s, on the system's monotonic clock), and its times in milliseconds.
class FrameLog {
public:
    explicit FrameLog(const std::filesystem::path& path) {
        if (path.empty()) return;
        file_.open(path);
        file_ << "frame,began_s,shown_s,interval_ms,work_ms,playback_ms\n" << std::fixed;
    }
    void begin_frame() {
        ++frame_;
        began_ = now();
    }
    std::uint64_t frame() const { return frame_; }
    void end_frame(const FrameTimes& times) {
        if (!file_.is_open()) return;
        file_ << frame_ << ',' << began_ << ',' << now() << ',' << 1e3 * times.interval << ','
              << 1e3 * times.work << ',' << 1e3 * times.playback << std::endl;
    }

private:
    static double now() {
        return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
            .count();
    }

    std::ofstream file_;
    std::uint64_t frame_ = 0;
    double began_ = 0.0;  // s
};

}  // namespace cambrian
