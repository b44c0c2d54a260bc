#pragma once

// Accelerations of articulated bodies by elimination from the leaves to the root (R. Featherstone,
// Rigid Body Dynamics Algorithms, 2008, chapter 7), in world axes about the centre of mass.

#include "spatial/motion.h"

namespace cambrian::spatial {

// What acts on the bodies: wrenches about the centre of mass, without gravity, which moves only
// that centre; efforts of the joints; and what their implicit motors add to the inertia of each
// degree.
struct Loads {
    Six wrench[kMostBodies];
    double effort[kMostJointDegrees] = {};
    double damping[kMostJointDegrees] = {};
};

// The elimination at one state.
struct Factors {
    Six push[kMostJointDegrees];             // U = A S
    double inverse[kMostJointDegrees] = {};  // 1 / (S . U + damping)
    double root[6][6] = {};                  // Cholesky factor of the root's articulated inertia
};

// Accelerations of the joints' coordinates and of the root.
struct Response {
    double joint[kMostJointDegrees] = {};
    Vec3 root_turning = Vec3::Zero();  // rad/s^2
};

// Computes the accelerations and keeps the factors.
void solve_accelerations(const Model& model, const Kinematics& kinematics, const Loads& loads,
                         Factors& factors, Response& response);

// Computes the change of the accelerations by efforts of the joints alone.
void respond(const Model& model, const Kinematics& kinematics, const Factors& factors,
             const double* efforts, Response& response);

}  // namespace cambrian::spatial
