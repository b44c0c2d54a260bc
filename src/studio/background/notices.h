#pragma once

#include <optional>
#include <string>
#include <utility>

namespace cambrian {

enum class NoticeKind : unsigned char { kDone, kProblem };

struct Notice {
    NoticeKind kind = NoticeKind::kDone;
    std::string text;
    double shown_since = 0.0;  // s, of the window's clock
};

// The one notice shown at a time: a task done, or a problem and what to do next. A notice of a task
// done fades by itself; a problem stays until it is dismissed or replaced.
class Notices {
public:
    void tell(NoticeKind kind, std::string text, double now) {
        notice_ = Notice{kind, std::move(text), now};
    }
    void dismiss() { notice_.reset(); }
    const Notice* current(double now) {
        constexpr double done_seconds = 6.0;
        if (notice_ && notice_->kind == NoticeKind::kDone &&
            now - notice_->shown_since > done_seconds) {
            notice_.reset();
        }
        return notice_ ? &*notice_ : nullptr;
    }

private:
    std::optional<Notice> notice_;
};

}  // namespace cambrian
