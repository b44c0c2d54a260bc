#pragma once

// A registered effector: turns one brain output into the motor target of a part's joint, tick by
// tick (creature/README.md 6).

#include "core/registry.h"
#include "world/body_plan.h"
#include "world/physics_scene.h"
#include "world/scene_settings.h"

#include <memory>
#include <string>

namespace cambrian {

// The part an effector belongs to.
struct EffectorSite {
    const PlannedPart& part;
    std::size_t index;
};

// The share of the way to its target that a smoothed target goes in dt (s).
double smoothing_share(double dt, double time_constant);

struct EffectorKind {
    // Drives the part's joint from `signal` (within +-10, already mirrored). `memory` is one value,
    // the smoothed target, 0 (rest) at birth; `share` is smoothing_share() of the tick.
    using Drive = void (*)(const EffectorSite& site, double signal, double share,
                           const SceneSettings& settings, double& memory, PhysicsScene& scene);

    std::string id;
    std::string label;
    Drive drive = nullptr;
};

using EffectorRegistry = Registry<EffectorKind>;

EffectorRegistry builtin_effectors();

}  // namespace cambrian
