#pragma once

#include "math/bounds.h"
#include "math/types.h"

#include <cmath>

namespace cambrian {

inline constexpr int kMostFixedBoxes = 64;  // of one world

// A box that never moves and that bodies collide with, as with the ground.
struct FixedBox {
    Vec3 center = Vec3::Zero();                    // m
    Vec3 axis = Vec3::UnitX();                     // unit, along the length
    double half_length = 0.0;                      // m
    double half_width = 0.0;                       // m
    Vec3 low = Vec3::Zero(), high = Vec3::Zero();  // m, corners of the upright box around it
};

// Returns the box around a straight line from one point to another, which must not be the same,
// with this margin on all sides (m).
inline FixedBox box_around(const Vec3& from, const Vec3& to, double margin) {
    FixedBox box;
    const Vec3 along = to - from;
    const double length = along.norm();
    box.center = 0.5 * (from + to);
    box.axis = along / length;
    box.half_length = 0.5 * length + margin;
    box.half_width = margin;
    const double x = std::fabs(box.axis.x());
    const double y = std::fabs(box.axis.y());
    const Vec3 half(x * box.half_length + y * box.half_width,
                    y * box.half_length + x * box.half_width, 0.0);
    box.low = box.center - half;
    box.high = box.center + half;
    return box;
}

}  // namespace cambrian
