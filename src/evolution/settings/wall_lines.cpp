#include "evolution/settings/wall_lines.h"

#include "core/text/number_rows.h"
#include "core/text/number_text.h"
#include "world/fixed_box.h"

#include <fmt/core.h>

#include <cmath>

namespace cambrian {
namespace {

// Returns whether both ends are within the world. Where edges meet, the other end may be beyond
// one of them, at most once round the world.
bool is_within(const WallLine& wall, const WorldArea& area) {
    const Vec3 along = wall.to - wall.from;
    return area.contains(wall.from) && area.contains(area.torus().shortest(wall.to)) &&
           std::fabs(along.x()) <= area.width && std::fabs(along.y()) <= area.height;
}

}  // namespace

Result<std::vector<WallLine>> walls_of(std::string_view text) {
    const auto rows = number_rows(text, {4, static_cast<std::size_t>(kMostFixedBoxes), "wall",
                                         "\"x y x y; ...\", the ends of each in m"});
    if (!rows) return rows.error();
    std::vector<WallLine> walls;
    for (const std::vector<double>& row : *rows)
        walls.push_back({{row[0], row[1], 0.0}, {row[2], row[3], 0.0}});
    return walls;
}

Status check_wall(const WallLine& wall, const WorldArea& area) {
    if (!is_within(wall, area))
        return Error{"an end is outside the world, which has " + size_text(area)};
    const double length = (wall.to - wall.from).norm();
    if (length >= kLeastWall) return {};
    return Error{fmt::format("it is {} m long; expected at least {} m", short_text(length),
                             short_text(kLeastWall))};
}

}  // namespace cambrian
