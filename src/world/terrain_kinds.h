#pragma once

// The shapes of ground that are drawn by chance. Each is drawn outwards from the end of the level
// ground at the start, in m.

#include "core/random.h"
#include "world/terrain.h"

#include <string_view>
#include <vector>

namespace cambrian {

inline constexpr double kGroundPeriod = 64.0;    // m; drawn ground repeats after about so far
inline constexpr double kGapDepth = 2.0;         // m
inline constexpr double kHurdleThickness = 0.1;  // m
inline constexpr double kCourseSection = 3.0;    // m, of one obstacle of a course

// Returns one side of such ground, the first point of which is (pad, 0). `kind` is one of
// kTerrainIds but neither "flat" nor "drawn".
Terrain::Side draw_side(const TerrainSettings& settings, RandomStream& stream);

// Returns the points of one side from the middle of a world to its edge, which is half a width
// away. Unless the ground rises, it ends at height 0.
std::vector<GroundPoint> draw_half_world(const TerrainSettings& settings, RandomStream& stream);

}  // namespace cambrian
