#include "studio/view_recorder.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace cambrian {
namespace {

constexpr double kPictureInterval = 0.05;  // s between two pictures
constexpr int kMostWidth = 640;            // pixels; wider areas are made smaller

// Returns the size of an area's pictures; both sides are even, as some formats want it.
std::pair<int, int> picture_size(const ReadArea& area) {
    const double scale = std::min(1.0, static_cast<double>(kMostWidth) / area.width);
    const auto even = [scale](int side) {
        return std::max(2, 2 * static_cast<int>(std::lround(0.5 * scale * side)));
    };
    return {even(area.width), even(area.height)};
}

}  // namespace

// Pictures of another size cannot be in the same clip.
void ViewRecorder::fit_to(const ReadArea& area) {
    area_ = area;
    const auto [width, height] = picture_size(area);
    if (small_ && small_->width() == width && small_->height() == height) return;
    kept_.clear();
    small_.reset();
    if (auto made = Framebuffer::create(width, height)) small_.emplace(*std::move(made));
}

void ViewRecorder::take(const ReadArea& area, double now) {
    worker_.deliver();
    if (now < due_ || area.width < 2 || area.height < 2) return;
    due_ = std::max(due_ + kPictureInterval, now);
    if (!(area == area_)) fit_to(area);
    if (!small_) return;
    auto kept = std::make_shared<Kept>(Kept{now, nullptr});
    kept_.push_back(kept);
    while (kept_.front()->time < now - kSeconds - kPictureInterval)
        kept_.pop_front();
    worker_.submit([kept, packer = packer_, picture = read_scaled(area, *small_)](
                       const std::stop_token&) -> BackgroundWorker::Completion {
        auto packed = packer->pack(picture);
        return [kept, packed] { kept->packed = packed; };
    });
}

SeenClip ViewRecorder::seen(double now) const {
    SeenClip clip;
    clip.end = now;
    if (!small_) return clip;
    clip.width = small_->width();
    clip.height = small_->height();
    for (const auto& kept : kept_) {
        if (kept->packed) clip.pictures.push_back({kept->time, kept->packed});
    }
    return clip;
}

}  // namespace cambrian
