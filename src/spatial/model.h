#pragma once

// The bodies of an articulated creature in space: parts that rigid joints weld together are one
// body. Bodies and degrees of freedom are numbered from the root outwards.

#include "core/result.h"
#include "spatial/algebra.h"
#include "world/body_plan.h"

namespace cambrian::spatial {

inline constexpr int kMostBodies = 32;
inline constexpr int kMostParts = 32;
inline constexpr int kMostTouchingPairs = kMostParts * (kMostParts - 1) / 2;
inline constexpr int kMostJointDegrees = kMostDegrees * (kMostBodies - 1);
// Joints, then three each for the attitude and the centre of mass.
inline constexpr int kMostCoordinates = kMostJointDegrees + 6;

struct Body {
    int parent = -1;
    int first_degree = 0;
    int degree_count = 0;
    bool is_ball = false;  // its three degrees are a ball's, about z, y and x
    double mass = 0.0;     // kg
    Symmetric inertia;     // kg m^2, about the centre of mass, in the axes of its first part
    // The joint to the parent. Pivots are from the centres of mass, m.
    Turn joint_frame;  // of this body at rest, in the parent's axes
    Vec3 pivot_in_parent = Vec3::Zero();
    Vec3 pivot_in_body = Vec3::Zero();
};

// A hinge, a slide or one of the three of a ball. Several hinges of one joint follow one another:
// each turns about an axis of the frame that those before have turned. Those of a ball all turn
// about axes of the body; their limits are those of its angles (ball.h), and both bends together
// stay in a cone.
struct Degree {
    int body = 0;
    int axis = 2;  // of the joint frame: x, y or z
    bool slides = false;
    double low = 0.0, high = 0.0;  // rad or m, from rest
    double max_effort = 0.0;       // N m or N
    MotorMode mode = MotorMode::kPosition;
    double inertia = 0.0;     // kg m^2 or kg, that a motor at rest feels
    double rate_scale = 1.0;  // multiplies the speed limit of the settings
};

struct Part {
    int body = 0;
    Vec3 place = Vec3::Zero();  // m, from the body's centre of mass, in the body's axes
    Turn turn;                  // in the body's axes
    Vec3 half = Vec3::Zero();   // m
    double radius = 0.0;        // m, of the sphere around it
};

// Two parts that may touch each other; the first has the lower number.
struct TouchingPair {
    std::uint8_t first = 0, second = 0;
};

struct Model {
    int body_count = 0;
    int degree_count = 0;
    int part_count = 0;
    int ball_count = 0;
    int pair_count = 0;
    double mass = 0.0;     // kg
    double density = 1.0;  // kg/m^3
    Body bodies[kMostBodies];
    Degree degrees[kMostJointDegrees];
    Part parts[kMostParts];
    int balls[kMostBodies] = {};             // bodies whose joint is a ball
    TouchingPair pairs[kMostTouchingPairs];  // let_parts_touch() lists them
    bool measured[kMostParts] = {};          // PlannedPart::measures_forces
    Turn root_turn;                          // of the root at rest
    Vec3 center = Vec3::Zero();              // m, centre of mass at rest

    int coordinate_count() const { return degree_count + 6; }
    int attitude() const { return degree_count; }   // first coordinate of the attitude
    int place() const { return degree_count + 3; }  // first one of the centre of mass
};

// Fails, with a reason, for plans that have too many or too thin parts or that ask for what space
// has not.
Result<Model> build_model(const BodyPlan& plan, double density);

// Scales masses to another density (kg/m^3). Motors keep the stiffness that follows.
void change_density(Model& model, double density);

}  // namespace cambrian::spatial
