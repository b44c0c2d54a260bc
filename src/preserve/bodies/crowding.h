#pragma once

// The damped spring that keeps two bodies apart that could not be joined (preserve/README.md 9).

#include "preserve/bodies/swept_bounds.h"
#include "world/physics_scene.h"

namespace cambrian {

// A body that is pressed, and how many more forces it can take in this tick.
struct PressedBody {
    PhysicsScene& scene;
    const SweptBounds& extent;
    int& room;
    Vec3 shift = Vec3::Zero();  // m, from the scene to where the extent is
};

// Presses the two parts apart that overlap most, with equal and opposite forces during the next
// tick. Returns false, without an effect, if no parts overlap, they leave each other fast enough,
// or one of the bodies has no room.
bool press_apart(const PressedBody& a, const PressedBody& b);

}  // namespace cambrian
