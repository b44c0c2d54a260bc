#pragma once

// The interface through which sensors read the world around a creature. Reading changes nothing.

#include "math/types.h"

namespace cambrian {

class Surroundings {
public:
    virtual ~Surroundings() = default;

    // Returns the unit vector against gravity; 0 without gravity.
    virtual Vec3 up() const = 0;
};

}  // namespace cambrian
