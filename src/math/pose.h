#pragma once

// Position and orientation of a rigid body in space. Planar ones lie in z = 0 and rotate about z.

#include "math/elementary.h"
#include "math/types.h"

namespace cambrian {

struct Pose {
    Vec3 position = Vec3::Zero();  // m
    Rotation orientation = Rotation::Identity();
};

// The rate of change of a pose in world axes; `linear` is that of the pose's origin.
struct Twist {
    Vec3 linear = Vec3::Zero();   // m/s
    Vec3 angular = Vec3::Zero();  // rad/s
};

inline Pose planar_pose(double x, double y, double angle) {
    const SineCosine half = sine_cosine(0.5 * angle);
    return {Vec3(x, y, 0.0), Rotation(half.cosine, 0.0, 0.0, half.sine)};
}

// Returns the angle about z, in (-pi, pi].
inline double planar_angle(const Pose& pose) {
    const double w = pose.orientation.w();
    const double z = pose.orientation.z();
    return arc_tangent2(2.0 * w * z, w * w - z * z);
}

// Transforms a point from the pose's own frame to the frame that the pose is given in.
inline Vec3 transform(const Pose& pose, const Vec3& point) {
    return pose.position + pose.orientation * point;
}

}  // namespace cambrian
