#pragma once

// The wall on one side of a trial's start (simulator/README.md 5): news from afar that no body can
// feel in time.

#include "math/bounds.h"
#include "simulator/surroundings/light_source.h"
#include "world/fixed_box.h"

namespace cambrian {

inline constexpr double kWallHeight = 1.0;  // m, above the ground

// Where the wall of a trial is.
struct SideWall {
    int side = 0;       // 1: to the right (+x), -1: to the left
    FixedBox box = {};  // its near face is as far from the body as drawn
};

// Draws the side and the distance, from [wall_nearest, wall_farthest], of a world with a wall.
// Trials 2n and 2n + 1 have the same distance on opposite sides. `body` is the creature's before
// the test, m.
SideWall draw_side_wall(const Environment& environment, const LightDraw& draw, const Bounds& body);

// Returns the distance in m from a point to the wall's near face in a direction, 1 for +x or -1; 0
// within the wall and infinity if the wall is not there.
double distance_to_wall(const FixedBox& wall, const Vec3& point, int direction);

}  // namespace cambrian
