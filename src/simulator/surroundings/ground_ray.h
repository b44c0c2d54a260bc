#pragma once

// How far it is along a ray to what stands still (simulator/README.md 5).

#include "world/fixed_box.h"
#include "world/terrain.h"

namespace cambrian {

// Return the distance in m from a point along a unit vector; 0 within the ground or the box, and
// infinity if the ray meets none.
double distance_to_level_ground(const Vec3& from, const Vec3& direction);
double distance_to_box(const FixedBox& box, const Vec3& from, const Vec3& direction);
// The same, but looks no farther than `reach`.
double distance_to_terrain(const Terrain& terrain, const Vec3& from, const Vec3& direction,
                           double reach);

}  // namespace cambrian
