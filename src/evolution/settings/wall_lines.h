#pragma once

// The walls within a preserve, as its settings name them.

#include "core/result.h"
#include "evolution/settings/world_area.h"
#include "math/types.h"

#include <string_view>
#include <vector>

namespace cambrian {

inline constexpr double kLeastWall = 0.2;  // m, length

struct WallLine {
    Vec3 from = Vec3::Zero();  // m
    Vec3 to = Vec3::Zero();
};

// Reads "x y x y; x y x y": the ends of each wall in m. An empty text has none.
Result<std::vector<WallLine>> walls_of(std::string_view text);

// Fails if the wall is shorter than kLeastWall, or not within the world. Where edges meet, its
// other end may be beyond them.
Status check_wall(const WallLine& wall, const WorldArea& area);

}  // namespace cambrian
