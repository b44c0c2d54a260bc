#pragma once

// What an articulated body is, once built: masses, joints and boxes in flat arrays, never changed
// while it moves. Rigidly joined parts are one body; bodies stand in depth-first order, body 0 is
// the root, and every parent stands before its children. Boxes keep the order of the plan's parts.

#include "world/body_plan.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace cambrian {

inline constexpr int kMaxBodies = 32;
inline constexpr int kMaxParts = 64;
inline constexpr int kMaxCoordinates = kMaxBodies + 2;

using PerBody = double[kMaxBodies];
using PerPart = double[kMaxParts];
using PerCoordinate = double[kMaxCoordinates];

// Also the order of the planar scene's joint kinds.
enum class JointType : std::uint8_t { kRigid, kRotary, kLinear };

struct PartPair {
    std::uint8_t first = 0;
    std::uint8_t second = 0;
};

struct PlanarModel {
    int body_count = 0;
    int part_count = 0;
    double density = 1.0;     // kg/m^2, in all masses below
    double total_mass = 0.0;  // kg

    PerBody mass = {};     // kg
    PerBody inertia = {};  // kg m^2, about the body's centre of mass

    // The joint of a body to its parent; unused on body 0.
    JointType joint[kMaxBodies] = {};
    int parent[kMaxBodies] = {};
    int joint_part[kMaxBodies] = {};                     // plan part that carries this joint
    PerBody parent_anchor_x = {}, parent_anchor_y = {};  // m, in the parent's frame from its centre
    PerBody child_anchor_x = {}, child_anchor_y = {};    // m, in the body's frame from its centre
    PerBody rest_angle = {};                             // rad, relative to the parent
    PerBody axis_x = {}, axis_y = {};         // linear joints: unit, in the parent's frame
    PerBody limit_low = {}, limit_high = {};  // rad or m
    PerBody max_effort = {};                  // N m or N
    PerBody rate_scale = {};         // of the motors' speed limit, per rad/s: 1, or m (linear)
    PerBody effective_inertia = {};  // kg m^2 or kg: what a lone effort at this joint feels at rest
    MotorMode motor_mode[kMaxBodies] = {};

    // Boxes.
    int part_body[kMaxParts] = {};
    PerPart part_x = {}, part_y = {};           // m, centre in the body's frame
    PerPart part_angle = {};                    // rad, relative to the body
    PerPart part_cosine = {}, part_sine = {};   // of part_angle
    PerPart half_length = {}, half_width = {};  // m, along the box's x and y
    PerPart radius = {};                        // m, of the circle around the box
    std::vector<PartPair> colliding_pairs;      // boxes of different bodies that may touch

    double rest_center_x = 0.0, rest_center_y = 0.0;  // m, centre of mass of the plan's rest pose
    double rest_root_angle = 0.0;                     // rad
};

// Multiplies all masses so that they belong to another density.
void change_density(PlanarModel& model, double density);

}  // namespace cambrian
