#include "app/progress_bar.h"

#include "app/messages.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <unistd.h>

namespace cambrian {
namespace {

constexpr std::size_t kCells = 24;
constexpr auto kPause = std::chrono::milliseconds(100);
constexpr double kTooEarlyToTell = 0.5;  // s

std::string clock_text(double seconds) {
    const auto whole = static_cast<long long>(std::min(seconds, 1e9));
    char text[32];
    if (whole >= 3600) {
        std::snprintf(text, sizeof text, "%lld:%02lld:%02lld", whole / 3600, whole / 60 % 60,
                      whole % 60);
    } else {
        std::snprintf(text, sizeof text, "%lld:%02lld", whole / 60, whole % 60);
    }
    return text;
}

}  // namespace

ProgressBar::ProgressBar(const EvaluationProgress& progress, std::uint32_t generations)
    : progress_(progress), generations_(generations), shown_(::isatty(STDERR_FILENO) != 0) {
    if (shown_) thread_ = std::jthread([this](const std::stop_token& stop) { draw_until(stop); });
}

ProgressBar::~ProgressBar() {
    if (!shown_) return;
    thread_.request_stop();
    thread_.join();
    clear();
}

void ProgressBar::finish_generation(std::string_view line) {
    const std::lock_guard lock(terminal_);
    trials_done_ += progress_.total.load();
    ++finished_;
    if (shown_) clear();
    print_line(line);
    if (shown_) draw();
}

void ProgressBar::draw_until(const std::stop_token& stop) {
    std::condition_variable_any woken;
    std::unique_lock lock(terminal_);
    while (!stop.stop_requested()) {
        draw();
        woken.wait_for(lock, stop, kPause, [] { return false; });
    }
}

void ProgressBar::draw() {
    std::fprintf(stderr, "\r%s\033[K", text().c_str());
}

void ProgressBar::clear() {
    std::fputs("\r\033[K", stderr);
}

std::string ProgressBar::text() const {
    const double total = std::max(1.0, static_cast<double>(progress_.total.load()));
    const double done = std::min(total, static_cast<double>(progress_.done.load()));
    const bool complete = finished_ >= generations_;
    const double share = complete ? 1.0 : (finished_ + done / total) / generations_;
    const auto filled = static_cast<std::size_t>(share * kCells);
    const double seconds = stopwatch_.seconds();
    const double trials = static_cast<double>(trials_done_) + done;
    std::string line = "generation " + std::to_string(finished_) + " of " +
                       std::to_string(generations_) + " [" + std::string(filled, '#') +
                       std::string(kCells - filled, '.') + "] " +
                       std::to_string(static_cast<int>(share * 100)) + " %";
    if (seconds < kTooEarlyToTell || share <= 0.0) return line;
    return line + "  " + std::to_string(static_cast<long long>(trials / seconds)) +
           " creatures/s  " + clock_text(seconds / share - seconds) + " left";
}

}  // namespace cambrian
