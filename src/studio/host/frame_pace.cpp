#include "studio/host/frame_pace.h"

#include <algorithm>

namespace cambrian {
namespace {

constexpr double kSlowDrawing = 0.015;   // s
constexpr double kSlowLight = 0.030;     // s; a plain scene is hardly quicker than a light one
constexpr double kQuickDrawing = 0.007;  // s
constexpr double kSlowFor = 1.0;         // s
constexpr double kQuickFor = 10.0;       // s
constexpr double kLongestFrame = 0.1;    // s; longer pauses count as much
constexpr int kMostRaises = 2;

}  // namespace

void FramePace::note(double drawing, double elapsed) {
    drawing_[noted_ % kFrames] = drawing;
    if (++noted_ < kFrames) return;
    std::array<double, kFrames> sorted = drawing_;
    const auto middle = sorted.begin() + kFrames / 2;
    std::nth_element(sorted.begin(), middle, sorted.end());
    const double step = std::min(elapsed, kLongestFrame);
    const double slow = tier_ == Scenery::kFull ? kSlowDrawing : kSlowLight;
    slow_ = *middle > slow ? slow_ + step : 0.0;
    quick_ = *middle < kQuickDrawing ? quick_ + step : 0.0;
    if (slow_ >= kSlowFor && tier_ != Scenery::kPlain) {
        choose(tier_ == Scenery::kFull ? Scenery::kLight : Scenery::kPlain);
    } else if (quick_ >= kQuickFor && tier_ != Scenery::kFull && raised_ < kMostRaises) {
        ++raised_;
        choose(tier_ == Scenery::kPlain ? Scenery::kLight : Scenery::kFull);
    }
}

void FramePace::choose(Scenery tier) {
    tier_ = tier;
    noted_ = 0;
    slow_ = 0.0;
    quick_ = 0.0;
}

}  // namespace cambrian
