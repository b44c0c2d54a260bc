#pragma once

// The values of a brain's slots and outputs over the last 3 s, one reading per tick.

#include "brain/brain.h"

#include <cstddef>
#include <deque>
#include <vector>

namespace cambrian {

class SignalTrace {
public:
    static constexpr std::size_t kLength = 180;  // ticks

    void clear() { ticks_.clear(); }
    void add(const Brain& brain, std::size_t outputs);
    // Return the readings, oldest first, at most kLength.
    std::vector<double> of_slot(Slot slot) const;
    std::vector<double> of_output(std::size_t output) const;

private:
    struct Tick {
        std::vector<double> slots;
        std::vector<double> outputs;
    };
    std::deque<Tick> ticks_;
};

}  // namespace cambrian
