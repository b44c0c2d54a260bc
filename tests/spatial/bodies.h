#pragma once

// Bodies and scenes for tests of physics in space.

#include "core/random.h"
#include "spatial/spatial_scene.h"

#include <memory>

namespace cambrian {

// Returns one box at rest whose centre is the origin.
BodyPlan one_solid(const Vec3& half_extents);

// Returns a random tree with all kinds of joints in space, mirrored or not, in the attitude of its
// genes. Muscles have this strength, N/m^2.
BodyPlan random_solid(RandomStream& random, int parts, double strength);

// Returns a planar plan with this depth (m) in space. Its densities are those of the plane over the
// depth; efforts stay.
BodyPlan with_depth(BodyPlan plan, double depth);

// Turns a plan with all that is in it.
BodyPlan turned_plan(BodyPlan plan, const Rotation& turn);

Environment weightless();  // no gravity, ground or medium; 1000 kg/m^3
Environment spatial_water();
Environment spatial_ground(double friction, double elasticity);

std::unique_ptr<PhysicsScene> make_solid(const BodyPlan& plan, const Environment& environment,
                                         const SceneSettings& settings = {});

// Sets the target of every degree of freedom to a sine of its own, of up to this frequency (Hz).
void swing(PhysicsScene& scene, const BodyPlan& plan, double fastest = 1.0);

// Advances by so many ticks, which must succeed.
void run_ticks(PhysicsScene& scene, int ticks);
// Puts the lowest corner 2 cm above the ground.
void stand(PhysicsScene& scene);

// Gives a single box at rest this place, attitude, velocity (m/s) and spin (rad/s).
struct SolidMotion {
    Vec3 place = Vec3::Zero();
    Rotation attitude = Rotation::Identity();
    Vec3 velocity = Vec3::Zero();
    Vec3 spin = Vec3::Zero();
};
void begin_box(PhysicsScene& scene, const SolidMotion& motion);

// Returns the angular momentum about the centre of mass, from the parts.
Vec3 angular_momentum(const PhysicsScene& scene, double density);

}  // namespace cambrian
