#pragma once

// What a scene knows of its creature's body, so that several bodies can be advanced as one.

#include "dynamics/stepping/step_control.h"
#include "world/joined_scenes.h"
#include "world/physics_scene.h"

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace cambrian {

struct SceneBody {
    SceneBody() { clear_slots(model, 0); }

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
    // Returns the body, which is brought into `room` if it has been packed. It is packed again by
    // close(), which must be called before anything else is done with the scene.
    virtual SceneBody& open(SceneBody& room) = 0;
    virtual void close() = 0;
};

// The memory of a step, and room for the bodies that take it.
struct StepWorkspace final : SceneWorkspace {
    StepWorkspace(const IntegratorKind& integrator, const SceneSettings& settings)
        : control(integrator, settings) {}

    // Of several scenes that are advanced as one.
    SceneBody& joined_room() {
        if (!joined) joined = std::make_unique<SceneBody>();
        return *joined;
    }
    SceneBody& room(std::size_t index) {
        while (rooms.size() <= index)
            rooms.push_back(std::make_unique<SceneBody>());
        return *rooms[index];
    }

    StepControl control;
    std::vector<std::unique_ptr<SceneBody>> rooms;
    std::unique_ptr<SceneBody> joined;
};

// Scenes of articulated bodies that are advanced as one (dynamics/README.md 21).

std::unique_ptr<JoinedScenes> join_body_scenes(std::span<PhysicsScene* const> scenes);

}  // namespace cambrian
