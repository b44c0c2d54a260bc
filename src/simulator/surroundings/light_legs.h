#pragma once

// How a creature followed the light, leg by leg. A leg lasts kLegTime; distances (m) are from the
// centre of mass to the light.

#include "math/types.h"

#include <cstddef>
#include <vector>

namespace cambrian {

struct LightLeg {
    double start = 0.0;
    double end = 0.0;      // so far
    double nearest = 0.0;  // so far
    double mean = 0.0;     // over the ticks so far
    int ticks = 0;
};

class LightLegs {
public:
    // Memory for a trial of so many seconds.
    void reserve(double duration);
    // Both before a tick and after it.
    void begin(double distance);
    void watch(double distance);
    // Counts on as if nothing moved any more, until there are so many legs.
    void rest(std::size_t legs);

    const std::vector<LightLeg>& all() const { return legs_; }

private:
    std::vector<LightLeg> legs_;
};

}  // namespace cambrian
