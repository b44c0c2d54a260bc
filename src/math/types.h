#pragma once

// Vectors and rotations. No other header names Eigen's types.

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace cambrian {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Mat2 = Eigen::Matrix2d;
using Rotation = Eigen::Quaterniond;  // unit quaternion

}  // namespace cambrian
