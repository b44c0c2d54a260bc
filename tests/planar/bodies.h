#pragma once

// Scenes with small bodies for the tests of physics.

#include "planar/planar_scene.h"
#include "support/body_plans.h"

#include <memory>

namespace cambrian {

std::unique_ptr<PhysicsScene> make_scene(const BodyPlan& plan, const Environment& environment,
                                         const SceneSettings& settings = {});

// About the centre of mass, kg m^2/s, of parts of this density in kg/m^2.
struct AngularMomentum {
    double sum = 0.0;
    double gross = 0.0;  // with the absolute values of all parts
};
AngularMomentum angular_momentum_of(const PhysicsScene& scene, double density);

}  // namespace cambrian
