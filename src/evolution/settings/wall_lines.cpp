#include "evolution/settings/wall_lines.h"

#include "core/text/number_text.h"
#include "core/text/parsed_number.h"
#include "world/fixed_box.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace cambrian {
namespace {

// Removes the first piece of a text, up to a separator, and returns it.
std::string_view take_piece(std::string_view& text, char separator) {
    const std::size_t end = std::min(text.find(separator), text.size());
    const std::string_view piece = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    return piece;
}

// Returns the four numbers of a wall, with spaces between.
std::optional<WallLine> wall_of(std::string_view text) {
    std::vector<double> numbers;
    while (!text.empty()) {
        const std::string_view word = take_piece(text, ' ');
        if (word.empty()) continue;
        const auto number = parsed_number<double>(word);
        if (!number || !std::isfinite(*number) || numbers.size() == 4) return std::nullopt;
        numbers.push_back(*number);
    }
    if (numbers.size() != 4) return std::nullopt;
    return WallLine{{numbers[0], numbers[1], 0.0}, {numbers[2], numbers[3], 0.0}};
}

bool is_within(const Vec3& point, double width, double height) {
    return std::fabs(point.x()) <= 0.5 * width && std::fabs(point.y()) <= 0.5 * height;
}

}  // namespace

Result<std::vector<WallLine>> walls_of(std::string_view text) {
    std::vector<WallLine> walls;
    while (!text.empty()) {
        const std::string_view piece = take_piece(text, ';');
        if (piece.find_first_not_of(' ') == std::string_view::npos) continue;
        if (walls.size() == static_cast<std::size_t>(kMostFixedBoxes))
            return Error{fmt::format("more than {} walls", kMostFixedBoxes)};
        const std::optional<WallLine> wall = wall_of(piece);
        if (!wall) {
            return Error{fmt::format(
                "wall {} is not four numbers; expected \"x y x y; ...\", the ends of each in m",
                walls.size() + 1)};
        }
        walls.push_back(*wall);
    }
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
