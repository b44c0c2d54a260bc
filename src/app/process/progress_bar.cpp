#include "app/process/progress_bar.h"

#include "app/process/messages.h"

#include <fmt/core.h>

#include <algorithm>

namespace cambrian {

ProgressBar::ProgressBar(const EvaluationProgress& progress, std::uint32_t generations,
                         std::uint32_t known, std::function<std::string()> remark)
    : progress_(progress),
      generations_(generations),
      known_(std::min(known, generations)),
      remark_(std::move(remark)),
      line_([this] { return text(); }) {}

Status ProgressBar::finish_generation(std::string_view line) {
    Status printed;
    line_.interrupt([&] {
        trials_done_ += progress_.total.load();
        ++finished_;
        printed = print_line(line);
    });
    return printed;
}

void ProgressBar::say_above(std::string_view message) {
    line_.interrupt([message] { say(message); });
}

std::string ProgressBar::text() const {
    const std::string remark = remark_ ? remark_() : "";
    return numbers() + (remark.empty() ? "" : "  " + remark);
}

std::string ProgressBar::numbers() const {
    const double total = std::max(1.0, static_cast<double>(progress_.total.load()));
    const double done = std::min(total, static_cast<double>(progress_.done.load()));
    const std::uint32_t wanted = generations_ - known_;
    const bool complete = finished_ >= wanted;
    const double share = complete ? 1.0 : (finished_ + done / total) / wanted;
    const double seconds = line_.seconds();
    const double trials = static_cast<double>(trials_done_) + done;
    std::string line =
        fmt::format("generation {} of {} {}", known_ + finished_, generations_, bar_text(share));
    const std::string left = time_left_text(share, seconds);
    if (left.empty()) return line;
    return fmt::format("{}  {} creatures/s{}", line, static_cast<long long>(trials / seconds),
                       left);
}

}  // namespace cambrian
