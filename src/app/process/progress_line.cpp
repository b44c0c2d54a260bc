#include "app/process/progress_line.h"

#include "core/text/shown_text.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <unistd.h>
#include <utility>

namespace cambrian {
namespace {

constexpr std::size_t kCells = 24;
constexpr auto kLinePause = std::chrono::milliseconds(100);
constexpr double kTooEarlyToTell = 0.5;  // s; before this time no remaining time is shown

std::string clock_text(double seconds) {
    const auto whole = static_cast<long long>(std::min(seconds, 1e9));
    if (whole >= 3600)
        return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
    return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

}  // namespace

std::string bar_text(double share) {
    const auto filled = static_cast<std::size_t>(share * kCells);
    return fmt::format("[{}{}] {} %", std::string(filled, '#'), std::string(kCells - filled, '.'),
                       static_cast<int>(share * 100));
}

std::string time_left_text(double share, double seconds) {
    if (seconds < kTooEarlyToTell || share <= 0.0) return "";
    return fmt::format("  {} left", clock_text(seconds / share - seconds));
}

ProgressLine::ProgressLine(std::function<std::string()> text)
    : text_(std::move(text)), shown_(::isatty(STDERR_FILENO) != 0) {
    if (shown_) thread_ = std::jthread([this](const std::stop_token& stop) { draw_until(stop); });
}

ProgressLine::~ProgressLine() {
    if (!shown_) return;
    thread_.request_stop();
    thread_.join();
    clear();
}

void ProgressLine::interrupt(const std::function<void()>& work) {
    const std::lock_guard lock(terminal_);
    if (shown_) clear();
    work();
    if (shown_) draw();
}

void ProgressLine::draw_until(const std::stop_token& stop) {
    std::condition_variable_any woken;
    std::unique_lock lock(terminal_);
    while (!stop.stop_requested()) {
        draw();
        woken.wait_for(lock, stop, kLinePause, [] { return false; });
    }
}

void ProgressLine::draw() const {
    std::fprintf(stderr, "\r%s\033[K", shown_whole(text_()).c_str());
}

void ProgressLine::clear() {
    std::fputs("\r\033[K", stderr);
}

}  // namespace cambrian
