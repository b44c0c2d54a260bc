#pragma once

// Coordinates of a motion and what follows from them.

#include "spatial/ball.h"
#include "spatial/model.h"

namespace cambrian::spatial {

// Works that are integrated along with the motion, J.
enum Work : std::uint8_t { kMotorWork, kGrossMotorWork, kDragWork, kPullWork, kWorkCount };

// Speeds are those of the joints, the angular momentum about the centre of mass and the velocity of
// that. The attitude of the root is exp(its three positions) * root. That of a ball in its joint
// frame is ball * exp(its three positions); its speeds are the spin against the parent in the axes
// of the body.
struct Motion {
    double position[kMostCoordinates] = {};
    double speed[kMostCoordinates] = {};
    double work[kWorkCount] = {};
    Rotation root = Rotation::Identity();
    struct Attitude {
        Rotation turn = Rotation::Identity();
    };
    Attitude ball[kMostBodies];  // of bodies whose joint is a ball
};

// Rates of positions and speeds, and powers in W.
struct MotionRate {
    double position[kMostCoordinates] = {};
    double speed[kMostCoordinates] = {};
    double power[kWorkCount] = {};
    Vec3 root_turning = Vec3::Zero();  // rad/s^2, angular acceleration of the root
};

// Positions, axes and velocities of the bodies in world axes, from the centre of mass of all.
struct Kinematics {
    Turn turn[kMostBodies];
    Vec3 place[kMostBodies];
    Vec3 spin[kMostBodies];           // rad/s
    Vec3 velocity[kMostBodies];       // m/s, of the body's centre of mass less that of all
    Six motion[kMostBodies];          // the same at the centre of mass of all
    Symmetric inertia[kMostBodies];   // about the body's own centre of mass
    Six axis[kMostJointDegrees];      // of each degree
    Six coriolis[kMostJointDegrees];  // velocity product of each degree
    Symmetric whole_inertia;          // of all, about the centre of mass
};

Vec3 coordinate_vector(const double* coordinates);
void set_coordinate_vector(double* coordinates, const Vec3& vector);

Motion rest_motion(const Model& model);

// Computes all of it but the velocity products of degrees without motion of their body.
void compute_kinematics(const Model& model, const Motion& motion, Kinematics& kinematics);

// Makes exp(chart) part of the attitude of the root and of each ball, and sets the charts to 0.
void restart_chart(const Model& model, Motion& motion);
// Sets the rates of charts that have just been started again.
void restart_chart_rates(const Model& model, const Motion& motion, const Vec3& root_spin,
                         MotionRate& rate);
// Copies what the charts of a step start from.
void copy_attitudes(const Model& model, const Motion& from, Motion& to);

// The attitude of a ball in its joint frame, and its spin there, rad/s.
Rotation ball_attitude(const Model& model, const Motion& motion, int body);
Vec3 ball_spin(const Model& model, const Motion& motion, int body);

double kinetic_energy(const Model& model, const Motion& motion, const Kinematics& kinematics);

}  // namespace cambrian::spatial
