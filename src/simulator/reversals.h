#pragma once

// Counts how often a joint changes direction, without small swings (simulator/README.md 2,
// shaking).

namespace cambrian {

class ReversalCounter {
public:
    explicit ReversalCounter(double coordinate) : low_(coordinate), high_(coordinate) {}

    void watch(double coordinate);
    int count() const { return count_; }

private:
    // rad or m; lowest and highest coordinate since the last reversal, which was at one of the two.
    double low_;
    double high_;
    int direction_ = 0;  // direction of the present swing; 0 before the first
    int count_ = 0;
};

}  // namespace cambrian
