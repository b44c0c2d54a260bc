#pragma once

// A bench creature in a scene of our own physics.

#include "bench/bench_creature.h"
#include "world/environment.h"
#include "world/physics_scene.h"
#include "world/scene_settings.h"

#include <cstddef>
#include <memory>

namespace cambrian::bench {

// Physics must accept the plan.
std::unique_ptr<PhysicsScene> make_planar_scene(const BodyPlan& plan,
                                                const Environment& environment,
                                                const SceneSettings& settings = {});

// Advances one tick with the creature's targets of that tick.
void advance_planar_scene(PhysicsScene& scene, const BenchCreature& creature, std::size_t tick);

}  // namespace cambrian::bench
