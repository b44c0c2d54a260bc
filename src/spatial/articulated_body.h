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

// Accelerations of the joints' coordinates and of the bodies, at the centre of mass of all; those
// by gravity are left out.
struct Response {
    double joint[kMostJointDegrees] = {};
    Six body[kMostBodies];

    const Vec3& root_turning() const { return body[0].angular; }  // rad/s^2
};

// Computes the accelerations and keeps the factors.
void solve_accelerations(const Model& model, const Kinematics& kinematics, const Loads& loads,
                         Factors& factors, Response& response);

// Efforts of the joints and wrenches on the bodies about the centre of mass of all.
struct Push {
    double effort[kMostJointDegrees] = {};
    Six wrench[kMostBodies];
};

// Computes the change of the accelerations by a push alone.
void respond(const Model& model, const Kinematics& kinematics, const Factors& factors,
             const Push& push, Response& response);
// Adds what a push does to speeds, or to their rates, of all coordinates.
void add_push(const Model& model, const Push& push, const Response& response, double* speeds);

}  // namespace cambrian::spatial
