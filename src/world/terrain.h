#pragma once

// Ground with a shape, in the plane: a line of straight pieces from left to right, solid below
// (planar/README.md 24). It has no end: what was drawn last repeats. Pieces may be vertical.

#include "core/result.h"
#include "world/terrain_settings.h"

#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

namespace cambrian {

struct GroundPoint {
    double x = 0.0, y = 0.0;  // m
};

inline constexpr double kShortestPiece = 0.02;    // m
inline constexpr double kNarrowestRidge = 0.05;   // m, also of slots
inline constexpr double kMostGroundAway = 500.0;  // m to either side, of drawn points
inline constexpr double kMostGroundHeight = 50.0;

// A straight piece of the ground. Its inner end is the one nearer to the start, or the left one of
// piece 0.
struct GroundPiece {
    int number;
    double x, y;                // m, of the inner end
    double end_x, end_y;        // m, of the outer end
    double way_x, way_y;        // unit, from the inner end to the outer one
    double normal_x, normal_y;  // unit, out of the ground
    double length;              // m
    // Sine of the turn at the ends: negative where the ground is convex, positive where it is
    // concave, about 0 where it goes straight on.
    double inner_turn, outer_turn;

    double left() const { return number < 0 ? end_x : x; }
    double right() const { return number < 0 ? x : end_x; }
};

// Fails, with the place, for a text of drawn points that make no ground.
Status check_ground_points(const std::string& text);

class Terrain {
public:
    // Returns the ground that the settings describe, or null if it is flat. Equal settings share
    // one ground while it is in use. Fails, with the place, for points that make no ground.
    static Result<std::shared_ptr<const Terrain>> make(const TerrainSettings& settings);

    // Pieces are numbered from left to right; piece 0 is the one at the start. Returns the piece
    // above or below which a point is.
    int piece_at(double x) const;
    GroundPiece piece(int number) const;
    // Returns the height of the ground at x; at a step, that of its outer side.
    double height(double x) const;
    struct Heights {
        double lowest = 0.0, highest = 0.0;  // m
    };
    // Returns those of all pieces above which some place between the bounds is.
    Heights heights(double left, double right) const;
    // Appends the points of the ground from left to right, the first and last not within the
    // bounds.
    void list_points(double left, double right, std::vector<GroundPoint>& points) const;

    // The least width of a ridge 5 cm below its top, in m; of ground without ridges, a large one.
    double narrowest() const { return narrowest_; }

    // One side of the ground, in distance from the start. Its points from `loop` on repeat, each
    // time farther away and higher.
    struct Side {
        std::vector<GroundPoint> points;
        std::size_t loop = 0;
        double period = 0.0, rise = 0.0;  // m

        GroundPoint point(std::size_t index) const {
            if (index < points.size()) return points[index];
            const std::size_t count = points.size() - loop;
            const std::size_t round = (index - loop) / count;
            const auto rounds = static_cast<double>(round);
            const GroundPoint& first = points[loop + (index - loop) % count];
            return {first.x + rounds * period, first.y + rounds * rise};
        }
        // Returns the number of points whose distance is at most this one.
        std::size_t count_within(double distance) const;
    };

private:
    Terrain(Side right, Side left);
    GroundPiece make_piece(int number) const;
    // Those of one side, outwards: the points' own, and those of the first round that repeats.
    std::vector<GroundPiece> make_pieces(int direction) const;

    Side right_, left_;
    GroundPiece middle_ = {};
    std::vector<GroundPiece> right_pieces_, left_pieces_;
    double narrowest_ = 0.0;
};

}  // namespace cambrian
