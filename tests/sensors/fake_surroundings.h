#pragma once

#include "world/surroundings.h"

namespace cambrian {

// Tells what a test puts into it, the same everywhere.
class FakeSurroundings final : public Surroundings {
public:
    Vec3 up() const override { return upwards; }

    Vec3 upwards = Vec3::UnitY();
};

}  // namespace cambrian
