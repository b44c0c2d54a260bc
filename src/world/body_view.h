#pragma once

// The interface through which sensors, scoring and drawing read a simulated body. Parts have the
// indices of the body plan, including parts with rigid joints. Reading is fast and changes nothing.

#include "math/bounds.h"
#include "math/pose.h"
#include "world/body_plan.h"

#include <cstddef>
#include <cstdint>

namespace cambrian {

class BodyView {
public:
    virtual ~BodyView() = default;

    virtual std::size_t part_count() const = 0;
    virtual Pose part_pose(std::size_t part) const = 0;
    virtual Vec3 part_center(std::size_t part) const = 0;  // m; faster than the pose
    virtual Vec3 part_axis(std::size_t part) const = 0;    // unit vector along the part's length
    virtual Twist part_twist(std::size_t part) const = 0;  // at the part's centre

    // Returns a coordinate of the joint between a part and its parent, from rest, in rad or m; 0
    // for the root, for rigid joints and for degrees of freedom that the joint has not.
    virtual double joint_coordinate(const JointDegree& degree) const = 0;
    virtual double joint_rate(const JointDegree& degree) const = 0;  // rad/s or m/s
    // Motor, N m or N, at the last tick's end.
    virtual double joint_effort(const JointDegree& degree) const = 0;
    // Return the same of a joint's first degree of freedom.
    double joint_coordinate(std::size_t part) const { return joint_coordinate(first_degree(part)); }
    double joint_rate(std::size_t part) const { return joint_rate(first_degree(part)); }
    double joint_effort(std::size_t part) const { return joint_effort(first_degree(part)); }

    // Returns the stretch s of a part, its rate in 1/s, and the effort of its motor in J at the
    // last tick's end; 0 for rigid parts.
    virtual double stretch(std::size_t part) const = 0;
    virtual double stretch_rate(std::size_t part) const = 0;
    virtual double stretch_effort(std::size_t part) const = 0;
    // Returns half the present length, width and depth, in m; the depth is 0 in the plane.
    virtual Vec3 part_half_extents(std::size_t part) const = 0;

    // Returns whether the face touched the ground or another part during the last tick.
    virtual bool face_touched(std::size_t part, Face face) const = 0;

    // The following are means over the last tick, impacts included. They are 0 before the first
    // tick, and always 0 unless PlannedPart::measures_forces is set.
    // Returns the acceleration of the part's centre minus gravity, in world axes, m/s^2.
    virtual Vec3 part_specific_force(std::size_t part) const = 0;
    // Returns the sum of the normal forces of ground and other parts on the part, in N.
    virtual double part_load(std::size_t part) const = 0;

    virtual double mass() const = 0;                   // kg
    virtual Vec3 center_of_mass() const = 0;           // m
    virtual Vec3 center_of_mass_velocity() const = 0;  // m/s
    virtual double kinetic_energy() const = 0;         // J
    virtual Bounds bounds() const = 0;                 // of all corners of all parts
    virtual double lowest_point() const = 0;           // m, bounds().low.y(); faster
    // Returns the least height of a part above the ground, straight down, in m.
    virtual double ground_gap() const { return lowest_point(); }

protected:
    static JointDegree first_degree(std::size_t part) { return {static_cast<std::uint16_t>(part)}; }
};

// Returns the point of a part at this share of its half length from its centre, in m.
inline Vec3 point_on_axis(const BodyView& body, std::size_t index, double share) {
    const double half_length = body.part_half_extents(index).x();
    return body.part_center(index) + share * half_length * body.part_axis(index);
}

}  // namespace cambrian
