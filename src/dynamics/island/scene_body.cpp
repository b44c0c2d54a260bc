#include "dynamics/island/scene_body.h"

namespace cambrian {

void begin_tick(SceneBody& body) {
    MotorDrive& drive = body.forcing.drive;
    const double activity = body.motors_off ? 0.0 : 1.0;
    for (int i = 0; i < body.model.body_count; i += kLanes) {
        store_lanes(drive.start + i, activity * load_lanes(body.state.drive_start + i));
        store_lanes(drive.end + i, activity * load_lanes(body.state.drive_end + i));
    }
}

void end_tick(SceneBody& body) {
    SimulationState& state = body.state;
    for (int i = 0; i < body.model.body_count; i += kLanes)
        store_lanes(state.drive_start + i, load_lanes(state.drive_end + i));
    if (!body.forcing.pulls.empty()) state.cache_is_current = false;
    body.forcing.pulls.clear();
}

}  // namespace cambrian
