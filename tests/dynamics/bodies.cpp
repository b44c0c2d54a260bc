#include "dynamics/bodies.h"

#include "support/catch.h"

namespace cambrian {

std::unique_ptr<PhysicsScene> make_scene(const BodyPlan& plan, const Environment& environment,
                                         const SceneSettings& settings) {
    auto scene = planar_scene_kind().make(plan, environment, settings);
    REQUIRE(scene);
    return std::move(*scene);
}

}  // namespace cambrian
