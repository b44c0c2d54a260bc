#include "world/ground_stroke.h"

#include "core/text/number_rows.h"
#include "core/text/number_text.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace cambrian {
namespace {

using GroundPoints = std::vector<GroundPoint>;

constexpr double kHardlyMatters = 0.03;                // m off a straight line
constexpr double kSpikeDepth = 0.05;                   // m from a tip, where its width is measured
constexpr double kLeastSpike = 1.1 * kNarrowestRidge;  // m, with some room for rounding
constexpr double kLeastRun = 0.1;  // m between two points that do not make a wall

double snapped(double value, double limit) {
    return std::clamp(std::round(value / kGroundSnap) * kGroundSnap, -limit, limit);
}

// Returns how far a point is from the line between two others, measured straight up where the line
// is not a wall.
double off_line(const GroundPoint& point, const GroundPoint& from, const GroundPoint& to) {
    const double x = to.x - from.x;
    const double y = to.y - from.y;
    const double length = std::sqrt(x * x + y * y);
    if (length == 0.0) return std::fabs(point.y - from.y);
    return std::fabs(x * (point.y - from.y) - y * (point.x - from.x)) / length;
}

// Keeps the points between two kept ones that are off the line between them (Douglas and Peucker
// 1973).
void keep_between(const GroundPoints& points, std::size_t first, std::size_t last,
                  std::vector<bool>& kept) {
    std::size_t farthest = first;
    double most = kHardlyMatters;
    for (std::size_t i = first + 1; i < last; ++i) {
        const double off = off_line(points[i], points[first], points[last]);
        if (off <= most) continue;
        most = off;
        farthest = i;
    }
    if (farthest == first) return;
    kept[farthest] = true;
    keep_between(points, first, farthest, kept);
    keep_between(points, farthest, last, kept);
}

GroundPoints simplified(const GroundPoints& points) {
    std::vector<bool> kept(points.size(), false);
    kept.front() = kept.back() = true;
    keep_between(points, 0, points.size() - 1, kept);
    GroundPoints result;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (kept[i]) result.push_back(points[i]);
    }
    return result;
}

// Removes points that are so near to the one before that they would make a narrow ridge or slot.
GroundPoints spread(const GroundPoints& points) {
    GroundPoints result = {points.front()};
    for (std::size_t i = 1; i < points.size(); ++i) {
        const bool last = i + 1 == points.size();
        const double run = points[i].x - result.back().x;
        if (run > 0.0 && run < kLeastRun) {
            if (!last) continue;
            if (result.size() > 1) result.pop_back();
        }
        // Of a wall only the ends matter.
        const std::size_t count = result.size();
        if (count >= 2 && result[count - 2].x == result.back().x && points[i].x == result.back().x)
            result.pop_back();
        result.push_back(points[i]);
    }
    return result;
}

GroundPoints points_now(const TerrainSettings& settings) {
    GroundPoints points;
    if (settings.kind == "drawn") {
        const auto rows = number_rows(settings.points, {2, kMostGroundPoints, "point", ""});
        if (!rows) return points;
        for (const std::vector<double>& row : *rows)
            points.push_back({row[0], row[1]});
        return points;
    }
    const auto terrain = Terrain::make(settings);
    if (!terrain || *terrain == nullptr) return {{-kGroundKept, 0.0}, {kGroundKept, 0.0}};
    (*terrain)->list_points(-kGroundKept, kGroundKept, points);
    return points;
}

// Returns the height of a profile that is level beyond its ends; at a wall, that of the side named.
double height_at(const GroundPoints& points, double x, bool left_side) {
    if (points.empty()) return 0.0;
    if (x < points.front().x || (x == points.front().x && left_side)) return points.front().y;
    if (x > points.back().x || (x == points.back().x && !left_side)) return points.back().y;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const GroundPoint& from = points[i - 1];
        const GroundPoint& to = points[i];
        if (left_side ? to.x < x : to.x <= x) continue;
        if (to.x == from.x) return from.y;
        return from.y + (to.y - from.y) * (x - from.x) / (to.x - from.x);
    }
    return points.back().y;
}

std::string text_of(const GroundPoints& points) {
    std::string text;
    for (const GroundPoint& point : points) {
        if (!text.empty()) text += "; ";
        text += short_text(std::round(point.x * 1e4) * 1e-4) + ' ' +
                short_text(std::round(point.y * 1e4) * 1e-4);
    }
    return text;
}

void add_apart(GroundPoints& points, const GroundPoint& point) {
    const bool near = !points.empty() && point.x - points.back().x < kShortestPiece &&
                      std::fabs(point.y - points.back().y) < kShortestPiece;
    if (!near) points.push_back(point);
}

// Returns how wide a ridge or slot is on one side of its tip, near the tip (m).
double width_near(const GroundPoint& tip, const GroundPoint& beside) {
    const double height = std::fabs(beside.y - tip.y);
    const double width = std::fabs(beside.x - tip.x);
    if (width == 0.0) return 0.0;
    return height < kSpikeDepth ? kLeastSpike : width * kSpikeDepth / height;
}

// Removes the tips of ridges and slots that are too narrow for ground.
void blunt(GroundPoints& points) {
    for (std::size_t i = 1; i + 1 < points.size();) {
        const GroundPoint& at = points[i];
        const GroundPoint& before = points[i - 1];
        const GroundPoint& after = points[i + 1];
        const bool is_tip =
            (before.y < at.y) == (after.y < at.y) && before.y != at.y && after.y != at.y;
        if (!is_tip || width_near(at, before) + width_near(at, after) >= kLeastSpike) {
            ++i;
            continue;
        }
        points.erase(points.begin() + static_cast<std::ptrdiff_t>(i));
        if (i > 1) --i;  // its neighbour may be a tip now
    }
}

}  // namespace

std::vector<GroundPoint> snapped_stroke(std::span<const GroundPoint> stroke, bool straight) {
    if (stroke.empty()) return {};
    GroundPoints points(stroke.begin(), stroke.end());
    if (points.back().x < points.front().x) std::reverse(points.begin(), points.end());
    if (straight) points = {points.front(), points.back()};
    GroundPoints onward;
    for (const GroundPoint& point : points) {
        const GroundPoint at = {snapped(point.x, kMostGroundAway),
                                snapped(point.y, kMostGroundHeight)};
        if (!onward.empty() &&
            (at.x < onward.back().x || (at.x == onward.back().x && at.y == onward.back().y)))
            continue;
        onward.push_back(at);
    }
    if (onward.back().x - onward.front().x < kShortestStroke) return {};
    return spread(simplified(onward));
}

Result<TerrainSettings> with_stroke(const TerrainSettings& settings,
                                    std::span<const GroundPoint> stroke) {
    const GroundPoints before = points_now(settings);
    const double left = stroke.front().x;
    const double right = stroke.back().x;
    GroundPoints points;
    for (const GroundPoint& point : before) {
        if (point.x < left - kLeastRun) add_apart(points, point);
    }
    add_apart(points, {left, height_at(before, left, true)});
    for (const GroundPoint& point : stroke)
        add_apart(points, point);
    add_apart(points, {right, height_at(before, right, false)});
    for (const GroundPoint& point : before) {
        if (point.x > right + kLeastRun) add_apart(points, point);
    }
    blunt(points);
    GroundPoints apart;
    for (const GroundPoint& point : points)
        add_apart(apart, point);
    TerrainSettings drawn = settings;
    drawn.kind = "drawn";
    drawn.points = text_of(apart);
    if (Status ground = check_ground_points(drawn.points); !ground) return ground.error();
    return drawn;
}

}  // namespace cambrian
