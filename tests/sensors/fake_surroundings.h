#pragma once

#include "world/surroundings.h"

namespace cambrian {

// Surroundings with values that a test sets, the same everywhere.
class FakeSurroundings final : public Surroundings {
public:
    Vec3 up() const override { return upwards; }
    Light light(const Vec3& /*point*/) const override { return lit; }

    Vec3 upwards = Vec3::UnitY();
    Light lit;
};

}  // namespace cambrian
