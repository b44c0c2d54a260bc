#include "preserve/world/drawn_walls.h"

#include <algorithm>
#include <utility>

namespace cambrian {
namespace {

constexpr double kHalfThickness = 0.1;  // m; a mouth reaches no food behind a wall

Rectangle rectangle_of(const FixedBox& box) {
    return {box.center, box.axis, box.half_length, box.half_width};
}

Rectangle rectangle_of(const Bounds& bounds) {
    const Vec3 half = 0.5 * (bounds.high - bounds.low);
    return {0.5 * (bounds.low + bounds.high), Vec3::UnitX(), half.x(), half.y()};
}

}  // namespace

void DrawnWalls::replace(std::vector<WallLine> lines) {
    lines_ = std::move(lines);
    boxes_.clear();
    for (const WallLine& line : lines_)
        boxes_.push_back(box_around(line.from, line.to, kHalfThickness));
}

std::vector<Rectangle> DrawnWalls::rectangles() const {
    std::vector<Rectangle> all;
    for (const FixedBox& box : boxes_)
        all.push_back(rectangle_of(box));
    return all;
}

std::optional<std::size_t> DrawnWalls::nearest(const Vec3& point, double distance) const {
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
        const double there = distance_to(rectangle_of(boxes_[i]), point);
        if (there > distance || (found && there == distance)) continue;
        found = i;
        distance = there;
    }
    return found;
}

bool DrawnWalls::meet(const Bounds& bounds) const {
    const Rectangle all = rectangle_of(bounds);
    return meet(std::span(&all, 1));
}

bool DrawnWalls::meet(std::span<const Rectangle> parts) const {
    return std::any_of(boxes_.begin(), boxes_.end(), [&](const FixedBox& box) {
        const Rectangle wall = rectangle_of(box);
        return std::any_of(parts.begin(), parts.end(),
                           [&](const Rectangle& part) { return overlap(wall, part); });
    });
}

bool DrawnWalls::separate(const Vec3& from, const Vec3& to) const {
    const Vec3 along = to - from;
    const double length = along.norm();
    if (!(length > 0.0)) return false;
    const Rectangle path{0.5 * (from + to), along / length, 0.5 * length, 0.0};
    return meet(std::span(&path, 1));
}

}  // namespace cambrian
