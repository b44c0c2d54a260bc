#include "app/process/long_work.h"

#include "core/text/number_text.h"

#include <fmt/core.h>

#include <algorithm>

namespace cambrian {
namespace {

constexpr double kShort = 0.5;  // s; shorter work shows no progress

}  // namespace

void LongWork::begin(const std::string& stage, double length, const std::string& unit) {
    line_.interrupt([&] {
        stage_ = stage;
        length_ = length;
        unit_ = unit;
        began_ = line_.seconds();
        time_ = 0.0;
    });
}

std::string LongWork::text() const {
    const double seconds = line_.seconds() - began_;
    if (stage_.empty() || seconds < kShort) return "";
    const std::string start = fmt::format("{}, {} {} ", stage_, short_text(length_), unit_);
    const double share = length_ > 0.0 ? std::min(1.0, time_.load() / length_) : 0.0;
    if (share > 0.0) return start + bar_text(share) + time_left_text(share, seconds);
    return fmt::format("{}(since {} s)", start, static_cast<long long>(seconds));
}

}  // namespace cambrian
