#pragma once

// A registered kind of effector: converts one output of the brain into the motor target of a part's
// joint in every tick (creature/README.md 6).

#include "core/registry.h"
#include "world/body_plan.h"
#include "world/physics_scene.h"
#include "world/scene_settings.h"

#include <memory>
#include <string>

namespace cambrian {

// The part that an effector belongs to, and the degree of freedom of its joint that it drives.
struct EffectorSite {
    const PlannedPart& part;
    JointDegree joint;
};

// Returns the share of the way to its target that a smoothed value moves in dt (s).
double smoothing_share(double dt, double time_constant);

struct EffectorKind {
    // Sets the motor target of the part's joint from `signal` (within +-10, already mirrored).
    // `memory` is the smoothed target, 0 (rest) at birth; `share` is the smoothing_share() of the
    // tick.
    using Drive = void (*)(const EffectorSite& site, double signal, double share,
                           const SceneSettings& settings, double& memory, PhysicsScene& scene);

    std::string id;
    std::string label;
    Drive drive = nullptr;
};

using EffectorRegistry = Registry<EffectorKind>;

EffectorRegistry builtin_effectors();

}  // namespace cambrian
