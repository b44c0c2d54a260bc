#include "world/terrain.h"

#include "core/assert.h"
#include "core/text/number_rows.h"
#include "core/text/number_text.h"
#include "world/terrain_kinds.h"

#include <fmt/core.h>

#include <algorithm>
#include <mutex>
#include <utility>

namespace cambrian {
namespace {

constexpr double kStraight = 1e-9;       // sine of a turn that is none
constexpr double kRidgeDepth = 0.05;     // m below a top, where its width is measured
constexpr double kWideRidge = 1.0;       // m; wider ones are not measured
constexpr double kFarthestGround = 1e7;  // m
constexpr double kBeyondDrawn = 1000.0;  // m of level ground beyond drawn points

using GroundPoints = std::vector<GroundPoint>;

double distance_of(const GroundPoint& from, const GroundPoint& to) {
    const double x = to.x - from.x;
    const double y = to.y - from.y;
    return std::sqrt(x * x + y * y);
}

GroundPiece piece_between(const GroundPoint& inner, const GroundPoint& outer) {
    GroundPiece piece = {};
    piece.length = distance_of(inner, outer);
    piece.x = inner.x;
    piece.y = inner.y;
    piece.end_x = outer.x;
    piece.end_y = outer.y;
    piece.way_x = (outer.x - inner.x) / piece.length;
    piece.way_y = (outer.y - inner.y) / piece.length;
    piece.normal_x = -piece.way_y;
    piece.normal_y = piece.way_x;
    return piece;
}

// The sine of the turn from one line to the next, in the order of the points.
double turn_at(const GroundPoint& before, const GroundPoint& at, const GroundPoint& after) {
    const double lengths = distance_of(before, at) * distance_of(at, after);
    const double cross =
        (at.x - before.x) * (after.y - at.y) - (at.y - before.y) * (after.x - at.x);
    return lengths > 0.0 ? cross / lengths : 0.0;
}

bool goes_straight(const GroundPoint& before, const GroundPoint& at, const GroundPoint& after) {
    const double onward =
        (at.x - before.x) * (after.x - at.x) + (at.y - before.y) * (after.y - at.y);
    return onward >= 0.0 && std::fabs(turn_at(before, at, after)) < kStraight;
}

// Removes points between which the ground goes straight on.
void straighten(GroundPoints& points) {
    GroundPoints kept;
    for (const GroundPoint& point : points) {
        if (!kept.empty() && distance_of(kept.back(), point) == 0.0) continue;
        while (kept.size() >= 2 && goes_straight(kept[kept.size() - 2], kept.back(), point))
            kept.pop_back();
        kept.push_back(point);
    }
    points = std::move(kept);
}

// Returns how far from a top the ground is `depth` below it (m), in steps of one point from index
// `from`; kWideRidge if that is farther.
double width_beside(const GroundPoints& points, std::size_t top, int step, double depth) {
    const GroundPoint& at = points[top];
    const auto count = static_cast<std::ptrdiff_t>(points.size());
    GroundPoint before = at;
    for (auto i = static_cast<std::ptrdiff_t>(top) + step; i >= 0 && i < count; i += step) {
        const GroundPoint& here = points[static_cast<std::size_t>(i)];
        const double fall = depth < 0.0 ? here.y - at.y : at.y - here.y;
        if (fall >= std::fabs(depth)) {
            const double earlier = depth < 0.0 ? before.y - at.y : at.y - before.y;
            const double share = (std::fabs(depth) - earlier) / (fall - earlier);
            return std::fabs(before.x + share * (here.x - before.x) - at.x);
        }
        if (std::fabs(here.x - at.x) > kWideRidge) break;
        before = here;
    }
    return kWideRidge;
}

struct NarrowPlace {
    double width = kWideRidge;  // m
    double x = 0.0;             // m
};

// Finds the narrowest ridge, or slot with a negative depth, which has its top at one of the points.
NarrowPlace narrowest_of(const GroundPoints& points, double depth) {
    NarrowPlace narrowest;
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
        const double turn = turn_at(points[i - 1], points[i], points[i + 1]);
        if (depth < 0.0 ? turn <= 0.0 : turn >= 0.0) continue;
        const double width = width_beside(points, i, -1, depth) + width_beside(points, i, 1, depth);
        if (width < narrowest.width) narrowest = {width, points[i].x};
    }
    return narrowest;
}

Error at_point(std::size_t index, const std::string& what) {
    return {fmt::format("point {} {}", index + 1, what)};
}

Status check_ground_point(const GroundPoints& points, std::size_t i) {
    const GroundPoint& point = points[i];
    if (std::fabs(point.x) > kMostGroundAway)
        return at_point(i,
                        fmt::format("is at x = {} m; expected [-500, 500]", short_text(point.x)));
    if (std::fabs(point.y) > kMostGroundHeight)
        return at_point(
            i, fmt::format("is at a height of {} m; expected [-50, 50]", short_text(point.y)));
    if (i == 0) return {};
    if (point.x < points[i - 1].x)
        return at_point(i, fmt::format("is at x = {} m, left of the one before; the ground goes "
                                       "from left to right",
                                       short_text(point.x)));
    if (distance_of(points[i - 1], point) < kShortestPiece)
        return at_point(i, "is less than 0.02 m from the one before");
    return {};
}

Status check_ground_shape(const GroundPoints& points) {
    for (const double depth : {kRidgeDepth, -kRidgeDepth}) {
        const NarrowPlace narrow = narrowest_of(points, depth);
        if (narrow.width >= kNarrowestRidge) continue;
        return Error{fmt::format("the {} at x = {} m is {} m wide; expected at least 0.05 m",
                                 depth > 0.0 ? "ridge" : "slot", short_text(narrow.x),
                                 short_text(std::round(narrow.width * 1e4) * 1e-4))};
    }
    return {};
}

Result<GroundPoints> points_of(const std::string& text) {
    const auto rows = number_rows(text, {2, kMostGroundPoints, "point", "\"x y; x y; ...\" in m"});
    if (!rows) return rows.error();
    GroundPoints points;
    for (const std::vector<double>& row : *rows) {
        points.push_back({row[0], row[1]});
        if (Status fault = check_ground_point(points, points.size() - 1); !fault)
            return fault.error();
    }
    if (points.size() < 2)
        return Error{fmt::format("drawn ground has {} point{}; expected at least 2", points.size(),
                                 points.size() == 1 ? "" : "s")};
    if (Status fault = check_ground_shape(points); !fault) return fault.error();
    return points;
}

// Returns the side to the right, or to the left with all distances negated.
Terrain::Side side_of_drawn(GroundPoints points) {
    const std::size_t last = points.size() - 1;
    return {std::move(points), last, kBeyondDrawn, 0.0};
}

struct BothSides {
    Terrain::Side right, left;
};

// Returns the sides of ground that goes round a world. The line leads from the left edge of the
// world to the right one, where the ground has the same height.
BothSides sides_round_world(const GroundPoints& line, double width) {
    GroundPoints round;
    for (const double shift : {-width, 0.0, width}) {
        for (const GroundPoint& point : line)
            round.push_back({point.x + shift, point.y});
    }
    straighten(round);
    BothSides sides;
    for (const GroundPoint& point : round) {
        if (point.x > 0.0 && point.x <= width) sides.right.points.push_back(point);
        if (point.x <= 0.0 && point.x > -width) sides.left.points.push_back({-point.x, point.y});
    }
    std::reverse(sides.left.points.begin(), sides.left.points.end());
    sides.right.period = width;
    sides.left.period = width;
    return sides;
}

Result<BothSides> drawn_sides(const TerrainSettings& settings) {
    Result<GroundPoints> drawn = points_of(settings.points);
    if (!drawn) return drawn.error();
    GroundPoints points = *std::move(drawn);
    if (settings.world_width > 0.0) {
        const double edge = 0.5 * settings.world_width;
        points.insert(points.begin(), {-edge, points.front().y});
        points.push_back({edge, points.back().y});
        return sides_round_world(points, settings.world_width);
    }
    points.insert(points.begin(), {points.front().x - kBeyondDrawn, points.front().y});
    points.push_back({points.back().x + kBeyondDrawn, points.back().y});
    straighten(points);
    const auto first = std::find_if(points.begin(), points.end(),
                                    [](const GroundPoint& point) { return point.x > 0.0; });
    GroundPoints left(points.begin(), first);
    std::reverse(left.begin(), left.end());
    for (GroundPoint& point : left)
        point.x = -point.x;
    return BothSides{side_of_drawn({first, points.end()}), side_of_drawn(std::move(left))};
}

BothSides sides_of_world(const TerrainSettings& settings) {
    RandomStream right(stream_seed({settings.seed, 0}));
    RandomStream left(stream_seed({settings.seed, 1}));
    GroundPoints line = draw_half_world(settings, left);
    std::reverse(line.begin(), line.end());
    for (GroundPoint& point : line)
        point.x = -point.x;
    const GroundPoints half = draw_half_world(settings, right);
    line.insert(line.end(), half.begin(), half.end());
    return sides_round_world(line, settings.world_width);
}

BothSides sides_of_kind(const TerrainSettings& settings) {
    if (settings.world_width > 0.0) return sides_of_world(settings);
    const bool mirrored = settings.sides == "mirrored";
    RandomStream stream(stream_seed({settings.seed, 0}));
    Terrain::Side right = draw_side(settings, stream);
    if (mirrored) return {right, right};
    RandomStream other(stream_seed({settings.seed, 1}));
    return {std::move(right), draw_side(settings, other)};
}

bool is_level(const Terrain::Side& side) {
    return side.rise == 0.0 && std::all_of(side.points.begin(), side.points.end(),
                                           [](const GroundPoint& point) { return point.y == 0.0; });
}

// Grounds that are in use. The scenes of one world share theirs, which may be large.
class GroundsInUse {
public:
    std::shared_ptr<const Terrain> find(const TerrainSettings& settings) {
        const std::lock_guard lock(mutex_);
        for (const auto& [known, ground] : grounds_) {
            if (known == settings) return ground.lock();
        }
        return nullptr;
    }
    void add(const TerrainSettings& settings, const std::shared_ptr<const Terrain>& ground) {
        const std::lock_guard lock(mutex_);
        std::erase_if(grounds_, [](const auto& each) { return each.second.expired(); });
        grounds_.emplace_back(settings, ground);
    }

private:
    std::mutex mutex_;
    std::vector<std::pair<TerrainSettings, std::weak_ptr<const Terrain>>> grounds_;
};

GroundsInUse& grounds_in_use() {
    static GroundsInUse grounds;
    return grounds;
}

}  // namespace

Status check_ground_points(const std::string& text) {
    const auto points = points_of(text);
    return points ? Status() : Status(points.error());
}

Result<std::shared_ptr<const Terrain>> Terrain::make(const TerrainSettings& settings) {
    std::shared_ptr<const Terrain> flat;
    if (settings.is_flat()) return flat;
    if (auto known = grounds_in_use().find(settings)) return known;
    BothSides sides;
    if (settings.kind == "drawn") {
        Result<BothSides> drawn = drawn_sides(settings);
        if (!drawn) return drawn.error();
        sides = *std::move(drawn);
    } else {
        sides = sides_of_kind(settings);
        straighten(sides.right.points);
        straighten(sides.left.points);
    }
    if (is_level(sides.right) && is_level(sides.left)) return flat;
    std::shared_ptr<const Terrain> made(new Terrain(std::move(sides.right), std::move(sides.left)));
    grounds_in_use().add(settings, made);
    return made;
}

Terrain::Terrain(Side right, Side left)
    : right_(std::move(right)),
      left_(std::move(left)),
      middle_(make_piece(0)),
      right_pieces_(make_pieces(1)),
      left_pieces_(make_pieces(-1)),
      narrowest_(std::min(narrowest_of(right_.points, kRidgeDepth).width,
                          narrowest_of(left_.points, kRidgeDepth).width)) {}

std::size_t Terrain::Side::count_within(double distance) const {
    distance = std::min(distance, kFarthestGround);
    const auto within = [&](double x) {
        const auto after = std::upper_bound(
            points.begin(), points.end(), x,
            [](double value, const GroundPoint& point) { return value < point.x; });
        return static_cast<std::size_t>(after - points.begin());
    };
    if (distance < point(points.size()).x) return within(distance);
    const double round = std::max(1.0, std::floor((distance - points[loop].x) / period));
    const auto rounds = static_cast<std::size_t>(round);
    std::size_t count =
        std::max(within(distance - round * period), loop) + rounds * (points.size() - loop);
    while (point(count - 1).x > distance)
        --count;
    while (point(count).x <= distance)
        ++count;
    return count;
}

int Terrain::piece_at(double x) const {
    if (x >= right_.points.front().x) return static_cast<int>(right_.count_within(x));
    if (-x >= left_.points.front().x) return -static_cast<int>(left_.count_within(-x));
    return 0;
}

// The left side is worked on as its mirror image.
GroundPiece Terrain::make_piece(int number) const {
    const GroundPoint right = right_.points.front();
    const GroundPoint left = left_.points.front();
    if (number == 0) {
        const GroundPoint start{-left.x, left.y};
        GroundPiece middle = piece_between(start, right);
        middle.outer_turn = turn_at(start, right, right_.point(1));
        middle.inner_turn = turn_at({-left_.point(1).x, left_.point(1).y}, start, right);
        return middle;
    }
    const Side& side = number > 0 ? right_ : left_;
    const GroundPoint& far = number > 0 ? left : right;
    const auto index = static_cast<std::size_t>(number > 0 ? number : -number);
    const GroundPoint inner = side.point(index - 1);
    const GroundPoint outer = side.point(index);
    const GroundPoint before = index > 1 ? side.point(index - 2) : GroundPoint{-far.x, far.y};
    GroundPiece piece = piece_between(inner, outer);
    piece.number = number;
    piece.inner_turn = turn_at(before, inner, outer);
    piece.outer_turn = turn_at(inner, outer, side.point(index + 1));
    if (number > 0) return piece;
    piece.x = -piece.x;
    piece.end_x = -piece.end_x;
    piece.way_x = -piece.way_x;
    piece.normal_x = -piece.normal_x;
    return piece;
}

std::vector<GroundPiece> Terrain::make_pieces(int direction) const {
    const Side& side = direction > 0 ? right_ : left_;
    const std::size_t count = 2 * side.points.size() - side.loop;
    std::vector<GroundPiece> pieces;
    for (std::size_t i = 1; i <= count; ++i)
        pieces.push_back(make_piece(direction * static_cast<int>(i)));
    return pieces;
}

GroundPiece Terrain::piece(int number) const {
    if (number == 0) return middle_;
    const Side& side = number > 0 ? right_ : left_;
    const std::vector<GroundPiece>& pieces = number > 0 ? right_pieces_ : left_pieces_;
    const auto index = static_cast<std::size_t>(number > 0 ? number : -number) - 1;
    if (index < pieces.size()) return pieces[index];
    const std::size_t once = side.points.size();
    const std::size_t looped = once - side.loop;
    const std::size_t round = (index - once) / looped;
    const auto rounds = static_cast<double>(round);
    GroundPiece piece = pieces[once + (index - once) % looped];
    const double away = number > 0 ? rounds * side.period : -rounds * side.period;
    piece.number = number;
    piece.x += away;
    piece.end_x += away;
    piece.y += rounds * side.rise;
    piece.end_y += rounds * side.rise;
    return piece;
}

double Terrain::height(double x) const {
    const GroundPiece here = piece(piece_at(x));
    if (here.way_x == 0.0) return here.end_y;
    return here.y + (x - here.x) * (here.way_y / here.way_x);
}

Terrain::Heights Terrain::heights(double left, double right) const {
    std::vector<GroundPoint> points;
    list_points(left, right, points);
    Heights heights{points.front().y, points.front().y};
    for (const GroundPoint& point : points) {
        heights.lowest = std::min(heights.lowest, point.y);
        heights.highest = std::max(heights.highest, point.y);
    }
    return heights;
}

void Terrain::list_points(double left, double right, std::vector<GroundPoint>& points) const {
    const int first = piece_at(left);
    const int last = piece_at(right);
    for (int number = first; number <= last; ++number) {
        const GroundPiece here = piece(number);
        const GroundPoint inner{here.x, here.y};
        const GroundPoint outer{here.end_x, here.end_y};
        if (number == first) points.push_back(number >= 0 ? inner : outer);
        points.push_back(number >= 0 ? outer : inner);
    }
}

}  // namespace cambrian
