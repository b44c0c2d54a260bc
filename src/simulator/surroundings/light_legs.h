#pragma once

// Distances of a creature to the light, for each leg of a trial. A leg lasts from one jump of
// the light to the next. Distances are from the centre of mass to the light, in m.

#include "math/types.h"

#include <cstddef>
#include <vector>

namespace cambrian {

struct LightLeg {
    double start = 0.0;
    double unit = 0.0;     // body length at the start, m, the unit of the way that was set
    double end = 0.0;      // so far
    double nearest = 0.0;  // so far
    double mean = 0.0;     // over the ticks so far
    int ticks = 0;
};

class LightLegs {
public:
    // Reserves memory for the legs of a trial.
    void reserve(std::size_t legs);
    // Records the distance at the start of a leg, before its first tick, and the body's length so
    // far.
    void begin(double distance, double length);
    // Records the distance after a tick.
    void watch(double distance);
    // Adds legs with the last distance until there are this many, for a trial that ended at rest.
    void rest(std::size_t legs);

    const std::vector<LightLeg>& all() const { return legs_; }

private:
    std::vector<LightLeg> legs_;
};

}  // namespace cambrian
