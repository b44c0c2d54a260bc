#pragma once

// The typical value of times that a few slow workers stretch. No result depends on it.

#include <algorithm>

namespace cambrian {

// Follows the value that seven of ten samples do not exceed. The others, those of slow workers
// among them, do not raise it.
class RunningQuantile {
public:
    // It starts at the least value, which must be positive.
    RunningQuantile(double least, double most) : least_(least), most_(most), value_(least) {}

    double value() const { return value_; }

    // The steps make the value follow the quantile: it rests where the shares of steps up and down
    // balance (Robbins and Monro 1951).
    void learn(double sample) {
        value_ = std::clamp(value_ * (sample > value_ ? kUp : kDown), least_, most_);
    }

private:
    static constexpr double kUp = 1.05;
    static constexpr double kDown = 0.98;
    double least_;
    double most_;
    double value_;
};

}  // namespace cambrian
