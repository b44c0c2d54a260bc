#pragma once

// What the world around a creature tells its sensors at one moment. Reading changes nothing.

#include "math/types.h"

namespace cambrian {

class Surroundings {
public:
    virtual ~Surroundings() = default;

    // Unit vector against gravity; 0 without gravity.
    virtual Vec3 up() const = 0;
};

}  // namespace cambrian
