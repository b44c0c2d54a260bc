#pragma once

// A ratio of two measured sums in which old measurements have little weight. No result depends on
// it.

namespace cambrian {

class FadingRatio {
public:
    // It starts at 1; each later measurement weighs one in `memory`, once there are as many.
    explicit FadingRatio(double memory) : kept_(1.0 - 1.0 / memory) {}

    double value() const { return above_ / below_; }

    void learn(double above, double below) {
        above_ = kept_ * above_ + above;
        below_ = kept_ * below_ + below;
    }

private:
    double kept_;
    double above_ = 1e-3;
    double below_ = 1e-3;
};

}  // namespace cambrian
