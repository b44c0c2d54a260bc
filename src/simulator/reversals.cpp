#include "simulator/reversals.h"

namespace cambrian {
namespace {

constexpr double kSmallestSwing = 0.05;  // rad

}  // namespace

void ReversalCounter::watch(double coordinate) {
    if (direction_ == 0) {
        const double swing = coordinate - turning_point_;
        if (swing > kSmallestSwing) direction_ = 1;
        if (swing < -kSmallestSwing) direction_ = -1;
        extreme_ = coordinate;
        return;
    }
    if ((coordinate - extreme_) * direction_ >= 0.0) {
        extreme_ = coordinate;
    } else if ((extreme_ - coordinate) * direction_ > kSmallestSwing) {
        turning_point_ = extreme_;
        extreme_ = coordinate;
        direction_ = -direction_;
        ++count_;
    }
}

}  // namespace cambrian
