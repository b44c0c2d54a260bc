#pragma once

// A body on a slope, beside the same body on flat ground under gravity that is turned as much. Both
// worlds are one, seen at two angles.

#include "world/body_plan.h"
#include "world/physics_scene.h"
#include "world/scene_kind.h"
#include "world/scene_settings.h"

#include <array>
#include <memory>

namespace cambrian {

class SlopeTwins {
public:
    // Ground rises to the right by the angle (degrees). Both begin 2 cm above it.
    SlopeTwins(const SceneKind& physics, const BodyPlan& plan, double degrees,
               const SceneSettings& settings);

    std::array<PhysicsScene*, 2> both() const { return {level_.get(), slope_.get()}; }
    // Returns the greatest distance of a part's centre from that of its twin (m).
    double apart() const;

private:
    double angle_;  // rad
    std::unique_ptr<PhysicsScene> level_, slope_;
};

// Returns settings under which the length of steps follows from contacts and time, not from errors.
// Those are measured along x and y, so that turned worlds take other steps.
SceneSettings with_even_steps(SceneSettings settings);

}  // namespace cambrian
