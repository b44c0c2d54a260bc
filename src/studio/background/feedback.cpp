#include "studio/background/feedback.h"

namespace cambrian {

void Feedback::tell(NoticeKind kind, const std::string& text) {
    notices_.tell(kind, text, now_);
    log_.write("notice", {{"text", text}, {"problem", kind == NoticeKind::kProblem}});
}

void Feedback::report(const Status& status) {
    if (!status) tell(NoticeKind::kProblem, status.error().message);
}

}  // namespace cambrian
