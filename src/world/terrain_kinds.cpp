#include "world/terrain_kinds.h"

#include "math/angle.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace cambrian {
namespace {

constexpr int kPiecesOfHill = 8;
constexpr double kLeastGap = 2.0 * kNarrowestRidge;  // m, of the widest; others have half of it

// The line drawn so far, from (0, 0).
class GroundLine {
public:
    double x() const { return points_.back().x; }
    double y() const { return points_.back().y; }
    void go_to(double x, double y) { points_.push_back({x, y}); }
    void run(double length) { go_to(x() + length, y()); }
    void rise(double height) { go_to(x(), y() + height); }
    std::vector<GroundPoint> take() { return std::move(points_); }
    std::size_t size() const { return points_.size(); }
    void cut_to(std::size_t size) { points_.resize(size); }

private:
    std::vector<GroundPoint> points_ = {{0.0, 0.0}};
};

// Draws the next feature. `share` is its height as a share of the greatest one, 0 for the last one
// before the ground repeats.
using DrawFeature = void (*)(const TerrainSettings& settings, double share, RandomStream& stream,
                             GroundLine& line);

void draw_slope(const TerrainSettings& /*settings*/, double /*share*/, RandomStream& /*stream*/,
                GroundLine& line) {
    line.run(kGroundPeriod);
}

void draw_rough(const TerrainSettings& settings, double share, RandomStream& stream,
                GroundLine& line) {
    line.go_to(line.x() + settings.spacing * stream.uniform(0.75, 1.25), settings.height * share);
}

void draw_hill(const TerrainSettings& settings, double share, RandomStream& stream,
               GroundLine& line) {
    const GroundPoint from{line.x(), line.y()};
    const double length = settings.spacing * stream.uniform(0.75, 1.25);
    const double rise = settings.height * share - from.y;
    for (int piece = 1; piece <= kPiecesOfHill; ++piece) {
        const double t = static_cast<double>(piece) / kPiecesOfHill;
        line.go_to(from.x + length * t, from.y + rise * t * t * (3.0 - 2.0 * t));
    }
}

void draw_stair(const TerrainSettings& settings, double /*share*/, RandomStream& /*stream*/,
                GroundLine& line) {
    line.rise(settings.height);
    line.run(settings.spacing);
}

void draw_plateau(const TerrainSettings& settings, double share, RandomStream& stream,
                  GroundLine& line) {
    line.go_to(line.x(), settings.height * share);
    line.run(settings.spacing * stream.uniform(0.5, 1.5));
}

void draw_gap(const TerrainSettings& settings, double /*share*/, RandomStream& stream,
              GroundLine& line) {
    line.run(settings.spacing * stream.uniform(0.75, 1.25));
    const double width = settings.gap * stream.uniform(0.5, 1.0);
    line.rise(-kGapDepth);
    line.run(width);
    line.rise(kGapDepth);
}

void draw_hurdle(const TerrainSettings& settings, double /*share*/, RandomStream& stream,
                 GroundLine& line) {
    line.run(settings.spacing * stream.uniform(0.75, 1.25));
    const double height = settings.height * stream.uniform(0.5, 1.0);
    line.rise(height);
    line.run(kHurdleThickness);
    line.rise(-height);
}

// Sections of 3 m, each harder than the last: after ten, all are as hard as the settings allow.
void draw_section(const TerrainSettings& settings, double /*share*/, RandomStream& stream,
                  GroundLine& line) {
    constexpr double kLevels = 10.0;
    const double section = std::floor(line.x() / kCourseSection + 0.5);
    const double end = (section + 1.0) * kCourseSection;
    const double level = std::min(1.0, (section + 1.0) / kLevels);
    const double height = level * settings.height;
    line.run(0.4 * kCourseSection);
    switch (stream.below(6)) {
        case 0:
            line.rise(height);
            line.run(kHurdleThickness);
            line.rise(-height);
            break;
        case 1:
            line.rise(height);
            break;
        case 2:
            line.rise(-height);
            break;
        case 3:
            line.rise(-kGapDepth);
            line.run(std::max(level * settings.gap, kNarrowestRidge));
            line.rise(kGapDepth);
            break;
        case 4:
            line.rise(0.6 * height);
            line.run(0.3);
            line.rise(0.4 * height);
            line.run(0.3);
            line.rise(-height);
            break;
        default:
            line.go_to(line.x() + 0.6, line.y() + height);
            line.go_to(line.x() + 0.6, line.y() - height);
            break;
    }
    line.run(std::max(end - line.x(), 0.3));
}

struct KindOfGround {
    std::string_view id;
    DrawFeature draw;
};

constexpr KindOfGround kKindsOfGround[] = {
    {"slope", draw_slope},    {"rough", draw_rough},    {"hills", draw_hill},
    {"stairs", draw_stair},   {"blocks", draw_plateau}, {"gaps", draw_gap},
    {"hurdles", draw_hurdle}, {"course", draw_section},
};

DrawFeature feature_of(std::string_view id) {
    for (const KindOfGround& kind : kKindsOfGround) {
        if (kind.id == id) return kind.draw;
    }
    return draw_slope;
}

TerrainSettings in_force(const TerrainSettings& at_full_level) {
    TerrainSettings settings = at_full_level;
    settings.height *= settings.level;
    settings.gap = std::max(settings.gap * settings.level, kLeastGap);
    return settings;
}

// Returns by how much the ground rises away from the level ground at the start, for each metre.
double steepness_of(const TerrainSettings& settings) {
    const SineCosine slope = sine_cosine_of_degrees(settings.slope);
    return settings.level * (slope.sine / slope.cosine);
}

// Draws what comes last before the edge of a world, so that the other side may follow.
void draw_last(DrawFeature draw, const TerrainSettings& settings, RandomStream& stream,
               GroundLine& line) {
    draw(settings, 0.0, stream, line);
    if (draw == draw_hurdle) line.run(settings.spacing);
}

// Draws features up to a distance; the last one ends before it, or there is none.
void draw_up_to(double length, const TerrainSettings& settings, RandomStream& stream,
                GroundLine& line) {
    const DrawFeature draw = feature_of(settings.kind);
    if (draw == draw_slope) {
        line.run(length);
        return;
    }
    std::size_t fitting = 0;
    RandomStream fitting_end = stream;
    for (;;) {
        const std::size_t begun = line.size();
        RandomStream last = stream;
        draw_last(draw, settings, last, line);
        const bool fits = line.x() <= length;
        line.cut_to(begun);
        if (!fits) break;
        fitting = begun;
        fitting_end = stream;
        const double share = stream.uniform();
        draw(settings, share, stream, line);
    }
    if (fitting == 0) return;
    line.cut_to(fitting);
    draw_last(draw, settings, fitting_end, line);
}

}  // namespace

Terrain::Side draw_side(const TerrainSettings& at_full_level, RandomStream& stream) {
    const TerrainSettings settings = in_force(at_full_level);
    const DrawFeature draw = feature_of(settings.kind);
    GroundLine line;
    while (line.x() < kGroundPeriod) {
        const double share = stream.uniform();
        draw(settings, share, stream, line);
    }
    draw(settings, 0.0, stream, line);
    Terrain::Side side;
    side.period = line.x();
    side.rise = line.y();
    side.points = line.take();
    side.points.pop_back();  // the first one of the next round
    const double steepness = steepness_of(settings);
    for (GroundPoint& point : side.points) {
        point.y += steepness * point.x;
        point.x += settings.pad;
    }
    side.rise += steepness * side.period;
    return side;
}

// Features are stretched to end at the edge.
std::vector<GroundPoint> draw_half_world(const TerrainSettings& at_full_level,
                                         RandomStream& stream) {
    const TerrainSettings settings = in_force(at_full_level);
    const double edge = 0.5 * settings.world_width;
    const double length = edge - settings.pad;
    GroundLine line;
    draw_up_to(length, settings, stream, line);
    if (!(line.x() > 0.0)) line.run(length);
    const double stretch = length / line.x();
    const double steepness = steepness_of(settings);
    std::vector<GroundPoint> points = line.take();
    for (GroundPoint& point : points) {
        point.x *= stretch;
        point.y += steepness * point.x;
        point.x = std::min(point.x + settings.pad, edge);
    }
    points.back().x = edge;
    return points;
}

}  // namespace cambrian
