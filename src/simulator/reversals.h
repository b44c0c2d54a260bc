#pragma once

// Counts how often a joint changes direction, ignoring swings too small to matter
// (evolution.md 7.7, shaking).

namespace cambrian {

class ReversalCounter {
public:
    explicit ReversalCounter(double coordinate)
        : turning_point_(coordinate), extreme_(coordinate) {}

    void watch(double coordinate);
    int count() const { return count_; }

private:
    double turning_point_;  // rad; where the present swing began
    double extreme_;        // rad; farthest point of the present swing
    int direction_ = 0;     // of the present swing; 0 before the first
    int count_ = 0;
};

}  // namespace cambrian
