#pragma once

// How much longer units take than their work explains: workers may be slow or busy with the units
// of other runs. No result depends on it.

#include <algorithm>

namespace cambrian {

class Patience {
public:
    // The multiple of the expected turnaround within which seven of ten units come back. The
    // others, those of a few slow workers among them, do not raise it.
    double factor() const { return factor_; }

    // Adds a unit's turnaround, s. The steps make the factor follow a quantile of the ratios:
    // it rests where the shares of steps up and down balance (Robbins and Monro 1951).
    void learn(double seconds, double expected) {
        factor_ *= seconds > factor_ * expected ? kUp : kDown;
        factor_ = std::clamp(factor_, 1.0, kMost);
    }

private:
    static constexpr double kUp = 1.05;
    static constexpr double kDown = 0.98;
    static constexpr double kMost = 100.0;
    double factor_ = 1.0;
};

}  // namespace cambrian
