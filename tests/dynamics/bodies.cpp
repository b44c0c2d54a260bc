#include "dynamics/bodies.h"

#include <stdexcept>

namespace cambrian {

std::unique_ptr<PhysicsScene> make_scene(const BodyPlan& plan, const Environment& environment,
                                         const SceneSettings& settings) {
    auto scene = planar_scene_kind().make(plan, environment, settings);
    if (!scene) throw std::runtime_error(scene.error().message);
    return std::move(*scene);
}

}  // namespace cambrian
