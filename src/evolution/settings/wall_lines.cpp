#include "evolution/settings/wall_lines.h"

#include "core/text/number_text.h"
#include "evolution/settings/number_rows.h"
#include "world/fixed_box.h"

#include <fmt/core.h>

#include <cmath>

namespace cambrian {
namespace {

bool is_within(const Vec3& point, double width, double height) {
    return std::fabs(point.x()) <= 0.5 * width && std::fabs(point.y()) <= 0.5 * height;
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

Status check_wall(const WallLine& wall, double width, double height) {
    if (!is_within(wall.from, width, height) || !is_within(wall.to, width, height)) {
        return Error{fmt::format("an end is outside the world, which has {} m x {} m",
                                 short_text(width), short_text(height))};
    }
    const double length = (wall.to - wall.from).norm();
    if (length >= kLeastWall) return {};
    return Error{fmt::format("it is {} m long; expected at least {} m", short_text(length),
                             short_text(kLeastWall))};
}

}  // namespace cambrian
