#pragma once

// What a scene knows of its creature's body, so that several bodies can be advanced as one.

#include "dynamics/stepping/step_control.h"
#include "world/physics_scene.h"

#include <utility>

namespace cambrian {

struct SceneBody {
    explicit SceneBody(PlanarModel&& built) : model(std::move(built)) {}

    PlanarModel model;
    ContactLaw law;
    Forcing forcing;
    bool motors_off = false;
    SimulationState state;
};

// Sets the targets of the motors for the next tick.
void begin_tick(SceneBody& body);
// Forgets what held for the last tick only.
void end_tick(SceneBody& body);

class BodyScene : public PhysicsScene {
public:
    virtual SceneBody& body() = 0;
};

struct StepWorkspace final : SceneWorkspace {
    StepWorkspace(const IntegratorKind& integrator, const SceneSettings& settings)
        : control(integrator, settings) {}
    StepControl control;
};

}  // namespace cambrian
