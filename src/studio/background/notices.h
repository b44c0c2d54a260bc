#pragma once

#include <optional>
#include <string>
#include <utility>

namespace cambrian {

enum class NoticeKind : unsigned char { kDone, kFeat, kProblem };

struct Notice {
    NoticeKind kind = NoticeKind::kDone;
    std::string text;
    double shown_since = 0.0;  // s, of the window's clock

    bool fades() const { return kind != NoticeKind::kProblem; }
    double seconds() const { return kind == NoticeKind::kFeat ? 12.0 : 6.0; }  // if it fades
};

// The one notice shown at a time: a task done, a feat of evolution, or a problem and what to do
// next. A problem stays until it is dismissed or replaced, others fade by themselves.
class Notices {
public:
    void tell(NoticeKind kind, std::string text, double now) {
        notice_ = Notice{kind, std::move(text), now};
    }
    void dismiss() { notice_.reset(); }
    const Notice* current(double now) {
        if (notice_ && notice_->fades() && now - notice_->shown_since > notice_->seconds())
            notice_.reset();
        return notice_ ? &*notice_ : nullptr;
    }

private:
    std::optional<Notice> notice_;
};

}  // namespace cambrian
