#pragma once

// Counts how often a joint changes direction, ignoring swings too small to matter
// (simulator/README.md 2, shaking).

namespace cambrian {

class ReversalCounter {
public:
    explicit ReversalCounter(double coordinate) : low_(coordinate), high_(coordinate) {}

    void watch(double coordinate);
    int count() const { return count_; }

private:
    // rad; lowest and highest since the last reversal. The one behind is where the swing began.
    double low_;
    double high_;
    int direction_ = 0;  // of the present swing; 0 before the first
    int count_ = 0;
};

}  // namespace cambrian
