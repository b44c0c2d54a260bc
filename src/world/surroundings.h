#pragma once

// What the world around a creature tells its sensors at one moment. Reading changes nothing.

#include "math/types.h"

namespace cambrian {

// Light as seen from a point.
struct Light {
    Vec3 direction = Vec3::Zero();  // unit, to the source; 0 where it is dark
    double intensity = 0.0;         // 1 at a lamp of brightness 1
};

class Surroundings {
public:
    virtual ~Surroundings() = default;

    // Unit vector against gravity; 0 without gravity.
    virtual Vec3 up() const = 0;
    // At a point of the world (m). Nothing casts shadows.
    virtual Light light(const Vec3& point) const = 0;
};

}  // namespace cambrian
