#pragma once

// The knowledge of a scene about its creature's body, so that several can be advanced as one.

#include "planar/stepping/step_control.h"
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
inline void begin_tick(SceneBody& body) {
    MotorDrive& drive = body.forcing.drive;
    const double activity = body.motors_off ? 0.0 : 1.0;
    for (int i = 0; i < body.model.body_count; i += kLanes) {
        store_lanes(drive.start + i, activity * load_lanes(body.state.drive_start + i));
        store_lanes(drive.end + i, activity * load_lanes(body.state.drive_end + i));
    }
}

// Forgets what held for the last tick only.
inline void end_tick(SceneBody& body) {
    SimulationState& state = body.state;
    for (int i = 0; i < body.model.body_count; i += kLanes)
        store_lanes(state.drive_start + i, load_lanes(state.drive_end + i));
    if (!body.forcing.pulls.empty()) state.cache_is_current = false;
    body.forcing.pulls.clear();
}

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

// Scenes of articulated bodies that are advanced as one (planar/README.md 21).

std::unique_ptr<JoinedScenes> join_body_scenes(std::span<PhysicsScene* const> scenes);

}  // namespace cambrian
