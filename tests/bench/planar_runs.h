#pragma once

// A bench creature in our own scene.

#include "bench/bench_creature.h"
#include "world/environment.h"
#include "world/physics_scene.h"
#include "world/scene_settings.h"

#include <cstddef>
#include <memory>

namespace cambrian::bench {

// The plan must be one that physics takes.
std::unique_ptr<PhysicsScene> make_planar_scene(const BodyPlan& plan,
                                                const Environment& environment,
                                                const SceneSettings& settings = {});

// One tick under the creature's targets of that tick.
void advance_planar_scene(PhysicsScene& scene, const BenchCreature& creature, std::size_t tick);

}  // namespace cambrian::bench
