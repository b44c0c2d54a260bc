#pragma once

// Small bodies and worlds for tests and benchmarks of physics, and operations on them.

#include "core/random.h"
#include "world/physics_scene.h"

namespace cambrian {

inline constexpr double kTestTick = 1.0 / 60;  // s
inline constexpr JointMotion kRigidJoint = JointMotion::kFixed;
inline constexpr JointMotion kRotaryJoint = JointMotion::kTurn;
inline constexpr JointMotion kLinearJoint = JointMotion::kSlide;

// Returns one box at rest with its centre at (x, y).
BodyPlan one_box(double half_length, double half_width, double x, double y, double angle = 0.0);

// Joins a part's proximal end to a point of its parent (in the parent's frame), at an angle to the
// parent.
void join(const BodyPlan& plan, PlannedPart& child, int parent, const Vec3& anchor, double angle);

// Adds a part that is joined in this way, with limits of +-1 rad.
PlannedPart& attach(BodyPlan& plan, int parent, const Vec3& anchor, double angle, JointMotion joint,
                    double half_length = 0.2, double half_width = 0.05);

// Makes a part deformable, with a muscle of 25 N/m over its area and at most 1.5 a second.
void make_deformable(PlannedPart& part, double low, double high);

// Returns boxes of 0.4 m x 0.1 m end to end along x, with rotary joints limited to +-limit rad.
BodyPlan chain(int parts, double limit, double x = 0.0, double y = 0.0);

// Returns a random tree for the acceptance tests of dynamics. Limits are +-0.4 to 1.2 rad (or 0.1
// m), largest efforts are strength * smaller width.
BodyPlan random_tree(RandomStream& random, int parts, double linear_share, double strength,
                     double height);

Environment empty_space();  // without gravity, ground or medium
Environment open_water();   // a medium without gravity and ground

// Lifts the lowest corner 2 cm above the ground and restarts the energy audit.
void stand_on_ground(PhysicsScene& scene);

// Advances tick by tick; returns false if the scene became invalid.
bool run(PhysicsScene& scene, double duration);

// Sets the targets of a flailing creature: sines of up to max_frequency Hz, different in every
// joint.
void flail(PhysicsScene& scene, const BodyPlan& plan, double max_frequency);

}  // namespace cambrian
