#pragma once

// Motors of the joints and drag of the medium.

#include "spatial/articulated_body.h"

namespace cambrian::spatial {

struct Medium {
    Vec3 gravity = Vec3::Zero();  // m/s^2
    double drag_linear = 0.0;     // N s/m^3
    double drag_quadratic = 0.0;  // kg/m^3
};

// The half-space y <= 0, and the coefficients of contact with it and between parts.
struct Ground {
    bool is_there = false;
    double friction = 0.0;     // Coulomb's coefficient
    double restitution = 0.0;  // coefficient of restitution, 0 to 1
};

// The motors' targets ramp from `start` to `end` within a tick.
struct Drive {
    double start[kMostJointDegrees] = {};
    double end[kMostJointDegrees] = {};
    double frequency = 0.0;    // rad/s; 0 while motors are off
    double speed_limit = 0.0;  // rad/s, or m/s for slides
};

// A force on a point of a body during one tick.
struct Pull {
    int body = 0;
    Vec3 point = Vec3::Zero();  // m, in the body's frame
    Vec3 force = Vec3::Zero();  // N
};

struct Forcing {
    Medium medium;
    Ground ground;
    Drive drive;
    Pull pulls[4];
    int pull_count = 0;
};

struct MotorPower {
    double net = 0.0, gross = 0.0;  // W
};

// Sets the efforts of all motors at a share of the tick, by the law of the plane
// (planar/README.md 6) for every degree.
MotorPower drive_joints(const Model& model, const Drive& drive, double share, const Motion& motion,
                        Loads& loads);

// Sets efforts and damping for a stage in the middle of a step, in which a motor responds to the
// rate that the stage itself gives its joint (planar/README.md 13). `time` is that since the
// step's start; `motion` is a prediction.
void drive_joints_implicitly(const Model& model, const Drive& drive, double share,
                             const Motion& start, const Motion& motion, double time, Loads& loads);

// Adds the drag of all parts and returns its power, W, at most 0.
double add_drag(const Model& model, const Medium& medium, const Kinematics& kinematics,
                const Vec3& drift, Loads& loads);

// Adds the pulls and returns their power, W.
double add_pulls(const Forcing& forcing, const Kinematics& kinematics, const Vec3& drift,
                 Loads& loads);

}  // namespace cambrian::spatial
