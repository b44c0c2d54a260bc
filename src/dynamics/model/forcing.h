#pragma once

// All inputs of the accelerations besides the state: the medium, the targets of the motors in the
// current tick, and forces that are constant during a step or tick.

#include "dynamics/model/planar_model.h"

#include <vector>

namespace cambrian {

inline constexpr int kMaxContacts = 64;

struct Medium {
    double gravity_x = 0.0, gravity_y = 0.0;         // m/s^2
    double drag_linear = 0.0, drag_quadratic = 0.0;  // of Environment
};

// Whether an evaluation includes the damping of the motors in its equations (implicit) or not.
enum class Motors { kExplicit, kImplicit };

// Constants of the motor law, and the target of every joint, which ramps linearly over a tick.
struct MotorDrive {
    double frequency = 0.0;        // rad/s
    double speed_limit = 0.0;      // rad/s
    PerBody start = {}, end = {};  // target at the tick's start and end
};

// A force in world axes on a material point of body a. Its reaction acts on body b, if there is
// one, at the same position.
struct HeldForce {
    int body_a = 0;
    int body_b = -1;                      // -1 is the ground
    double point_x = 0.0, point_y = 0.0;  // m, in body a's frame
    double force_x = 0.0, force_y = 0.0;  // N
};

// Forces of contacts and joint limits, constant during a step.
struct HeldForces {
    int contact_count = 0;
    HeldForce contacts[kMaxContacts];
    bool limits_active = false;
    PerBody limit_effort = {};  // N m or N
};

struct Forcing {
    Medium medium;
    MotorDrive drive;
    const HeldForces* held = nullptr;  // null: no contact forces
    std::vector<HeldForce> pulls;      // of this tick; at most kMostPulls of each creature
};

}  // namespace cambrian
