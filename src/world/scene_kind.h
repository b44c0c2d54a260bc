#pragma once

// A registered implementation of physics: its joints and a function that builds a scene.

#include "core/result.h"
#include "world/body_plan.h"
#include "world/environment.h"
#include "world/joined_scenes.h"
#include "world/joint_kind.h"
#include "world/physics_scene.h"
#include "world/scene_settings.h"

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace cambrian {

// A method that computes the motion of a scene.
struct IntegratorName {
    std::string id;     // of files: "dormand-prince"
    std::string label;  // "Dormand-Prince"
};

struct SceneKind {
    std::string id;
    std::string label;
    int dimensions = 2;
    JointRegistry joints;
    std::vector<IntegratorName> integrators;  // of SceneSettings::integrator
    std::string accurate_integrator;          // the id of the most accurate of them
    // Fails, with a reason, for bodies that physics rejects (too many parts, degenerate sizes).
    std::function<Result<std::unique_ptr<PhysicsScene>>(const BodyPlan&, const Environment&,
                                                        const SceneSettings&)>
        make;
    // Returns scenes, in the same environment, to be advanced as one. The sum of their sizes must
    // fit the largest one. Empty if the scenes of this kind cannot.
    std::function<std::unique_ptr<JoinedScenes>(std::span<PhysicsScene* const>)> join;
    SceneSize largest_join;
};

}  // namespace cambrian
