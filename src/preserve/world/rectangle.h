#pragma once

// A part as a rectangle in the world.

#include "math/bounds.h"
#include "math/torus.h"
#include "math/types.h"
#include "world/body_view.h"
#include "world/terrain.h"

#include <array>
#include <cstddef>

namespace cambrian {

struct Rectangle {
    Vec3 center = Vec3::Zero();  // m
    Vec3 axis = Vec3::UnitX();   // unit vector along its length
    double half_length = 0.0;    // m
    double half_width = 0.0;     // m

    Vec3 across() const { return {-axis.y(), axis.x(), 0.0}; }
};

// Returns the part as a rectangle with these half extents (m).
Rectangle rectangle_of(const BodyView& body, std::size_t index, const Vec3& half_extents);
std::array<Vec3, 4> corners_of(const Rectangle& rectangle);
Bounds bounds_of(const Rectangle& rectangle);
Rectangle moved(const Rectangle& rectangle, const Vec3& shift);

// Returns half of the length of a rectangle's projection on a unit vector.
double half_projection(const Rectangle& rectangle, const Vec3& direction);

// Returns whether two rectangles have a point in common (separating axis theorem).
bool overlap(const Rectangle& a, const Rectangle& b);
// Returns whether two boxes or images of them have a point in common.
bool overlap(const Bounds& a, const Bounds& b, const Torus& torus);

// Returns how far a rectangle would have to rise to be above the ground (m); negative if it may
// fall.
double depth_below(const Terrain& ground, const Rectangle& rectangle);

// Returns the distance of a point from a rectangle in m; 0 inside.
double distance_to(const Rectangle& rectangle, const Vec3& point);

}  // namespace cambrian
