#pragma once

// The studio's messages: notices to the user in the notice strip, and events in the status log.

#include "core/result.h"
#include "studio/background/notices.h"
#include "studio/background/status_log.h"

#include <filesystem>
#include <string>

namespace cambrian {

class Feedback {
public:
    explicit Feedback(const std::filesystem::path& status_log) : log_(status_log) {}

    // Must be called once a frame; `now` is in seconds of the window's clock.
    void set_time(double now) { now_ = now; }
    double now() const { return now_; }
    // Decides which notice this frame shows.
    void choose_notice() { notice_ = notices_.current(now_); }
    const Notice* notice() const { return notice_; }
    void dismiss() { notices_.dismiss(); }

    void tell(NoticeKind kind, const std::string& text);
    // Shows the error of a failure as a notice; does nothing for a success.
    void report(const Status& status);
    StatusLog& log() { return log_; }

private:
    StatusLog log_;
    Notices notices_;
    const Notice* notice_ = nullptr;
    double now_ = 0.0;  // s
};

}  // namespace cambrian
