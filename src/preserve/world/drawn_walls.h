#pragma once

// The walls within a preserve, which people draw (preserve/README.md 10).

#include "evolution/settings/wall_lines.h"
#include "math/torus.h"
#include "preserve/world/rectangle.h"
#include "world/fixed_box.h"

#include <optional>
#include <span>
#include <vector>

namespace cambrian {

class DrawnWalls {
public:
    // At most kMostFixedBoxes walls that passed check_wall(). Each has images all over the torus.
    explicit DrawnWalls(std::vector<WallLine> lines, const Torus& torus = {}) : torus_(torus) {
        replace(std::move(lines));
    }

    const std::vector<WallLine>& lines() const { return lines_; }
    // Valid until the walls change.
    std::span<const FixedBox> boxes() const { return boxes_; }
    // Returns the images that a body within these bounds can reach in a tick, at most
    // kMostFixedBoxes.
    std::vector<FixedBox> boxes_around(const Bounds& bounds) const;
    std::vector<Rectangle> rectangles() const;

    void replace(std::vector<WallLine> lines);
    // Returns the index of the wall nearest to a point, if it is within a distance (m).
    std::optional<std::size_t> nearest(const Vec3& point, double distance) const;

    // Returns the distance in m from a point along a unit vector to a wall, if one is within reach
    // (m); infinity if there is none.
    double distance(const Vec3& from, const Vec3& direction, double reach) const;

    // Returns whether a wall is within these bounds or overlaps one of the parts.
    bool meet(const Bounds& bounds) const;
    bool meet(std::span<const Rectangle> parts) const;
    // Returns whether a wall is between two points.
    bool separate(const Vec3& from, const Vec3& to) const;

private:
    template <class Visit>
    void visit(const Bounds& at, Visit visit) const;

    Torus torus_;
    std::vector<WallLine> lines_;
    std::vector<FixedBox> boxes_;
};

}  // namespace cambrian
