#pragma once

#include "world/body_view.h"

#include <cstddef>
#include <vector>

namespace cambrian {

// Measures the length of a body, the greatest distance of two of its corners, which does not depend
// on how the body is turned.
class LengthMeter {
public:
    explicit LengthMeter(std::size_t parts) : parts_(parts) {}

    // Returns the present length, or `so_far` if that is greater, in m. Allocates nothing.
    double longest(const BodyView& body, double so_far);

private:
    struct Disc {
        Vec3 center = Vec3::Zero();  // m
        double radius = 0.0;         // m, from the centre to a corner
    };
    std::vector<Disc> parts_;
};

}  // namespace cambrian
