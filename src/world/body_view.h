#pragma once

// What sensors, scoring and drawing may ask of a simulated body. Parts are indexed as in the body
// plan, rigidly joined ones included. Reading is cheap and changes nothing.

#include "math/bounds.h"
#include "math/pose.h"
#include "world/body_plan.h"

#include <cstddef>

namespace cambrian {

class BodyView {
public:
    virtual ~BodyView() = default;

    virtual std::size_t part_count() const = 0;
    virtual Pose part_pose(std::size_t part) const = 0;
    virtual Twist part_twist(std::size_t part) const = 0;  // at the part's centre

    // Coordinate of the joint between a part and its parent, relative to rest: rad or m; 0 on the
    // root and on rigid joints.
    virtual double joint_coordinate(std::size_t part) const = 0;
    virtual double joint_rate(std::size_t part) const = 0;  // rad/s or m/s
    virtual double joint_effort(
        std::size_t part) const = 0;  // motor, N m or N, at the last tick's end

    // Whether the face touched the ground or another part during the last tick.
    virtual bool face_touched(std::size_t part, Face face) const = 0;

    // Means over the last tick, impacts included; 0 before the first one, and always 0 unless
    // BodyPlan::measures_forces.
    // Acceleration of the part's centre less gravity, world axes, m/s^2.
    virtual Vec3 part_specific_force(std::size_t part) const = 0;
    // Sum of the normal forces on the part, N; of the ground and of other parts.
    virtual double part_load(std::size_t part) const = 0;

    virtual double mass() const = 0;                   // kg
    virtual Vec3 center_of_mass() const = 0;           // m
    virtual Vec3 center_of_mass_velocity() const = 0;  // m/s
    virtual double kinetic_energy() const = 0;         // J
    virtual Bounds bounds() const = 0;                 // of all corners of all parts
};

}  // namespace cambrian
