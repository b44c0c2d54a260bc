#include "bench/planar_runs.h"

#include "core/assert.h"
#include "planar/planar_scene.h"
#include "support/body_plans.h"

namespace cambrian::bench {

std::unique_ptr<PhysicsScene> make_planar_scene(const BodyPlan& plan,
                                                const Environment& environment,
                                                const SceneSettings& settings) {
    auto scene = planar_scene_kind().make(plan, environment, settings);
    CAMBRIAN_ASSERT(scene.has_value(), "benchmark bodies are valid");
    return std::move(scene).value();
}

void advance_planar_scene(PhysicsScene& scene, const BenchCreature& creature, std::size_t tick) {
    for (std::size_t part = 1; part < creature.plan.parts.size(); ++part)
        scene.set_target(part, creature.target(tick, part));
    scene.advance(kTestTick);
}

}  // namespace cambrian::bench
