#include "simulator/reversals.h"

#include <algorithm>

namespace cambrian {
namespace {

constexpr double kSmallestSwing = 0.05;  // rad or m; smaller swings do not count

}  // namespace

void ReversalCounter::watch(double coordinate) {
    low_ = std::min(low_, coordinate);
    high_ = std::max(high_, coordinate);
    const bool up = direction_ <= 0 && coordinate - low_ > kSmallestSwing;
    const bool down = direction_ >= 0 && high_ - coordinate > kSmallestSwing;
    if (!up && !down) return;
    if (direction_ != 0) ++count_;
    direction_ = up ? 1 : -1;
    (up ? high_ : low_) = coordinate;
}

}  // namespace cambrian
