#include "preserve/world/drawn_walls.h"

#include "simulator/surroundings/ground_ray.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace cambrian {
namespace {

constexpr double kHalfThickness = 0.1;   // m; a mouth reaches no food behind a wall
constexpr double kFarthestInTick = 4.0;  // m; no body gets farther in a tick

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

// Calls visit(index, shift) for each wall's images that may meet these bounds.
template <class Visit>
void DrawnWalls::visit(const Bounds& at, Visit visit) const {
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
        torus_.visit_images({boxes_[i].low, boxes_[i].high}, at,
                            [&](const Vec3& shift) { visit(i, shift); });
    }
}

std::vector<FixedBox> DrawnWalls::boxes_around(const Bounds& bounds) const {
    const Vec3 margin(kFarthestInTick, kFarthestInTick, 0.0);
    std::vector<FixedBox> found;
    visit({bounds.low - margin, bounds.high + margin}, [&](std::size_t index, const Vec3& shift) {
        if (found.size() == static_cast<std::size_t>(kMostFixedBoxes)) return;
        FixedBox& box = found.emplace_back(boxes_[index]);
        box.center += shift;
        box.low += shift;
        box.high += shift;
    });
    return found;
}

std::optional<std::size_t> DrawnWalls::nearest(const Vec3& point, double distance) const {
    std::optional<std::size_t> found;
    const Vec3 margin(distance, distance, 0.0);
    visit({point - margin, point + margin}, [&](std::size_t index, const Vec3& shift) {
        const double there = distance_to(moved(rectangle_of(boxes_[index]), shift), point);
        if (there > distance || (found && there == distance)) return;
        found = index;
        distance = there;
    });
    return found;
}

double DrawnWalls::distance(const Vec3& from, const Vec3& direction, double reach) const {
    Bounds way;
    way.add(from);
    way.add(from + reach * direction);
    double nearest = std::numeric_limits<double>::infinity();
    visit(way, [&](std::size_t index, const Vec3& shift) {
        nearest = std::min(nearest, distance_to_box(boxes_[index], from - shift, direction));
    });
    return nearest;
}

bool DrawnWalls::meet(const Bounds& bounds) const {
    const Rectangle all = rectangle_of(bounds);
    return meet(std::span(&all, 1));
}

bool DrawnWalls::meet(std::span<const Rectangle> parts) const {
    bool met = false;
    for (const Rectangle& part : parts) {
        visit(bounds_of(part), [&](std::size_t index, const Vec3& shift) {
            met = met || overlap(moved(rectangle_of(boxes_[index]), shift), part);
        });
    }
    return met;
}

bool DrawnWalls::separate(const Vec3& from, const Vec3& to) const {
    const Vec3 along = to - from;
    const double length = along.norm();
    if (!(length > 0.0)) return false;
    const Rectangle path{0.5 * (from + to), along / length, 0.5 * length, 0.0};
    return meet(std::span(&path, 1));
}

}  // namespace cambrian
