#include "pictures/scene/scene_builder.h"

#include "pictures/scene/organ_marks.h"
#include "pictures/scene/shown_shape.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace cambrian {
namespace {

constexpr double kGridPixels = 22.0;    // least distance of grid lines
constexpr double kPivotRadius = 0.028;  // m; largest radius of a drawn joint
const Color kLightColor = color_of(0xF2B632);

Vec2 planar(const Vec3& point) {
    return point.head<2>();
}

Vec2 half_of(const CreatureLook& look, std::size_t part) {
    return planar(shown_half_extents(look.phenotype.plan, look.stretches, part));
}

Shape part_shape(const Vec2& half, const Pose& pose, const Color& color, double pixel) {
    Shape shape;
    shape.center = planar(pose.position);
    shape.half_extents = half;
    shape.angle = planar_angle(pose);
    shape.radius = 0.45 * std::min(half.x(), half.y());
    shape.outline_width = std::max(1.5 * pixel, 0.008);
    shape.fill = color;
    shape.outline = mix(color, color_of(0x000000), 0.38F);
    return shape;
}

// Returns the ends of a face in the part's frame.
std::array<Vec2, 2> face_ends(const Vec2& half, Face face, double inset) {
    const double x = half.x();
    const double y = half.y();
    switch (face) {
        case Face::kDistal:
            return {Vec2(x, -y + inset), Vec2(x, y - inset)};
        case Face::kLeft:
            return {Vec2(-x + inset, y), Vec2(x - inset, y)};
        case Face::kProximal:
            return {Vec2(-x, -y + inset), Vec2(-x, y - inset)};
        case Face::kRight:
        case Face::kFront:
        case Face::kBack:
            break;
    }
    return {Vec2(-x + inset, -y), Vec2(x - inset, -y)};
}

void add_touched_faces(SceneFrame& frame, const CreatureLook& look, std::size_t index,
                       const Color& color, double pixel) {
    const Pose& pose = look.poses[index];
    const Vec2 half = half_of(look, index);
    const double width = std::max(3.0 * pixel, 0.012);
    const double inset = 0.45 * std::min(half.x(), half.y());
    for (const Face face : {Face::kDistal, Face::kLeft, Face::kProximal, Face::kRight}) {
        if ((look.touched[index] & face_bit(face)) == 0) continue;
        const auto ends = face_ends(half, face, inset);
        frame.add_line(planar(transform(pose, {ends[0].x(), ends[0].y(), 0.0})),
                       planar(transform(pose, {ends[1].x(), ends[1].y(), 0.0})), width, color);
    }
}

void add_pivots(SceneFrame& frame, const CreatureLook& look, double pixel) {
    for (const auto& [index, degree] : look.phenotype.effectors) {
        if (degree > 0) continue;
        const PlannedPart& part = look.phenotype.plan.parts[index];
        const double narrow = std::min(part.half_extents.x(), part.half_extents.y());
        const double radius = std::max(2.0 * pixel, std::min(kPivotRadius, 0.4 * narrow));
        const Vec3 inside = shown_point(part.anchor_in_child, look.stretches, index);
        const Vec2 at = planar(transform(look.poses[index], inside));
        frame.add_circle(at, radius, color_of(0x0B0E12, 0.75F));
        frame.add_circle(at, 0.45 * radius, color_of(0xF2F4F7, 0.85F));
    }
}

void add_vertical(SceneFrame& frame, double x, const WorldWindow& window, double pixel,
                  const Color& color) {
    frame.add_box({x, 0.5 * (window.low.y() + window.high.y())},
                  {0.5 * pixel, 0.5 * (window.high.y() - window.low.y())}, color);
}

void add_horizontal(SceneFrame& frame, double y, const WorldWindow& window, double pixel,
                    const Color& color) {
    frame.add_box({0.5 * (window.low.x() + window.high.x()), y},
                  {0.5 * (window.high.x() - window.low.x()), 0.5 * pixel}, color);
}

// Fills the ground column by column and draws its surface as a line over the steps between them.
void add_shaped_ground(SceneFrame& frame, const Palette& palette, const Camera& camera,
                       const Viewport& viewport) {
    constexpr double kColumnPixels = 3.0;
    const WorldWindow window = camera.window(viewport);
    const double half = 0.5 * kColumnPixels * camera.pixel();
    const double low = window.low.y() - 2.0 * camera.pixel();
    for (double x = window.low.x() + half; x < window.high.x() + 2.0 * half; x += 2.0 * half) {
        const double high = std::min(frame.ground.at(x), window.high.y() + 1.0);
        if (high > low)
            frame.add_box({x, 0.5 * (low + high)}, {half, 0.5 * (high - low)}, palette.ground);
    }
    const std::vector<Vec2>& surface = frame.ground.surface;
    for (std::size_t i = 1; i < surface.size(); ++i) {
        frame.add_line(surface[i - 1], surface[i], 3.0 * camera.pixel(), palette.ground_line);
    }
    const double spacing = mark_spacing(camera, kTickPixels);
    const double length = 7.0 * camera.pixel();
    for (double i = std::ceil(window.low.x() / spacing); i * spacing < window.high.x(); i += 1.0)
        frame.add_box({i * spacing, frame.ground.at(i * spacing) - 0.5 * length},
                      {0.5 * camera.pixel(), 0.5 * length}, palette.ground_line);
}

// Returns where in the spread of hues a gene node is, -0.5 to 0.5: the first in the middle, and
// nodes that follow each other far apart, by the golden ratio.
double hue_place(std::uint8_t node) {
    constexpr double kGoldenShare = 0.6180339887498949;
    const double turned = 0.5 + kGoldenShare * node;
    return turned - std::floor(turned) - 0.5;
}

}  // namespace

double mark_spacing(const Camera& camera, double least_pixels) {
    const double least = least_pixels / camera.pixels_per_metre;
    const double decade = std::pow(10.0, std::floor(std::log10(least)));
    for (const double step : {1.0, 2.0, 5.0}) {
        if (step * decade >= least) return step * decade;
    }
    return 10.0 * decade;
}

Color part_color(const BodyPart& part, double hue) {
    const double lightness = std::min(0.80, 0.66 + 0.03 * part.depth);
    constexpr double kHueSpread = 0.15;  // turns, of all gene nodes of a creature
    const double turned = hue + kHueSpread * hue_place(part.node);
    return color_of_hue(turned, part.mirror.across < 0 ? lightness - 0.04 : lightness, 0.105);
}

void add_grid(SceneFrame& frame, const Palette& palette, const Camera& camera,
              const Viewport& viewport) {
    const WorldWindow window = camera.window(viewport);
    const double spacing = mark_spacing(camera, kGridPixels);
    // Opaque lines are painted much faster, so coarse lines must come after the fine ones they
    // cross.
    for (const bool coarse : {false, true}) {
        const Color color = mix(frame.background, palette.faint, coarse ? 0.26F : 0.10F);
        const auto wanted = [coarse](double index) {
            return (std::fmod(std::fabs(index), 5.0) < 0.5) == coarse;
        };
        for (double i = std::ceil(window.low.x() / spacing); i * spacing < window.high.x(); i += 1)
            if (wanted(i)) add_vertical(frame, i * spacing, window, camera.pixel(), color);
        for (double i = std::ceil(window.low.y() / spacing); i * spacing < window.high.y(); i += 1)
            if (wanted(i)) add_horizontal(frame, i * spacing, window, camera.pixel(), color);
    }
}

void add_ground(SceneFrame& frame, const Palette& palette, const Camera& camera,
                const Viewport& viewport) {
    const WorldWindow window = camera.window(viewport);
    if (!frame.ground.is_flat()) return add_shaped_ground(frame, palette, camera, viewport);
    if (window.low.y() > 0.0) return;
    const Vec2 low = window.low - Vec2::Constant(2.0 * camera.pixel());
    const double width = window.high.x() - low.x() + 4.0 * camera.pixel();
    const double middle = low.x() + 0.5 * width;
    frame.add_box({middle, 0.5 * low.y()}, {0.5 * width, -0.5 * low.y()}, palette.ground);
    frame.add_box({middle, -camera.pixel()}, {0.5 * width, camera.pixel()}, palette.ground_line);
    const double spacing = mark_spacing(camera, kTickPixels);
    const double length = 7.0 * camera.pixel();
    for (double i = std::ceil(low.x() / spacing); i * spacing < window.high.x(); i += 1.0) {
        frame.add_box({i * spacing, -0.5 * length}, {0.5 * camera.pixel(), 0.5 * length},
                      palette.ground_line);
    }
}

void add_light(SceneFrame& frame, const Camera& camera, const Viewport& viewport,
               const Vec2& place) {
    const WorldWindow window = camera.window(viewport);
    const Vec2 margin = Vec2::Constant(0.6 * kLightPixels * camera.pixel());
    const Vec2 shown = place.cwiseMax(window.low + margin).cwiseMin(window.high - margin);
    const double size = camera.pixel() * (shown == place ? 1.0 : 0.5);
    constexpr int kRays = 8;
    for (int ray = 0; ray < kRays; ++ray) {
        const double angle = 2.0 * kPi * ray / kRays;
        const Vec2 way(std::cos(angle), std::sin(angle));
        frame.add_line(shown + 0.65 * kLightPixels * size * way, shown + kLightPixels * size * way,
                       2.0 * size, kLightColor);
    }
    frame.add_circle(shown, 0.5 * kLightPixels * size, color_of(0x0B0E12, 0.6F));
    frame.add_circle(shown, 0.42 * kLightPixels * size, kLightColor);
}

void add_shadow(SceneFrame& frame, const CreatureLook& look) {
    for (std::size_t i = 0; i < look.poses.size(); ++i) {
        const Vec2 half = half_of(look, i);
        const double angle = planar_angle(look.poses[i]);
        const double reach =
            std::fabs(std::cos(angle)) * half.x() + std::fabs(std::sin(angle)) * half.y();
        const double ground = frame.ground.at(look.poses[i].position.x());
        const double height = std::max(0.0, look.poses[i].position.y() - ground);
        Shape shadow;
        shadow.center = {look.poses[i].position.x(), ground - 0.03};
        shadow.half_extents = {reach, 0.02};
        shadow.radius = 0.02;
        shadow.blur = 0.03 + 0.05 * height;
        shadow.fill = color_of(0x000000, static_cast<float>(0.35 / (1.0 + 2.0 * height)));
        frame.shapes.push_back(shadow);
    }
}

void add_ghost(SceneFrame& frame, const Camera& camera, const CreatureLook& look) {
    for (std::size_t i = look.poses.size(); i-- > 0;) {
        Shape shape = part_shape(half_of(look, i), look.poses[i],
                                 part_color(look.phenotype.parts[i], look.hue), camera.pixel());
        shape.outline = with_alpha(shape.fill, 0.55F);
        shape.fill = with_alpha(shape.fill, 0.2F);
        frame.shapes.push_back(shape);
    }
}

void add_creature(SceneFrame& frame, const Palette& palette, const Camera& camera,
                  const CreatureLook& look) {
    const double pixel = camera.pixel();
    for (std::size_t i = look.poses.size(); i-- > 0;) {
        Shape shape = part_shape(half_of(look, i), look.poses[i],
                                 part_color(look.phenotype.parts[i], look.hue), pixel);
        if (look.highlight.covers(i, look.phenotype.parts[i])) {
            shape.fill = mix(shape.fill, color_of(0xFFFFFF), 0.15F);
            shape.outline = color_of(0xFFFFFF);
            shape.outline_width = std::max(2.0 * pixel, 0.010);
        }
        frame.shapes.push_back(shape);
        if (!look.touched.empty()) add_touched_faces(frame, look, i, palette.plot_best, pixel);
    }
    add_organ_marks(frame, look.phenotype, look.poses, look.stretches, pixel);
    add_pivots(frame, look, pixel);
}

void add_touched(SceneFrame& frame, const Color& color, const Camera& camera,
                 const CreatureLook& look) {
    for (std::size_t i = look.touched.size(); i-- > 0;)
        add_touched_faces(frame, look, i, color, camera.pixel());
}

void add_joints(SceneFrame& frame, const Camera& camera, const CreatureLook& look) {
    add_pivots(frame, look, camera.pixel());
}

int part_at(const Phenotype& phenotype, std::span<const Pose> poses, const Vec2& point,
            std::span<const double> stretches) {
    for (std::size_t i = 0; i < poses.size(); ++i) {
        const Vec3 offset = Vec3(point.x(), point.y(), 0.0) - poses[i].position;
        const Vec3 inside = poses[i].orientation.conjugate() * offset;
        const Vec3 half = shown_half_extents(phenotype.plan, stretches, i);
        if (std::fabs(inside.x()) <= half.x() && std::fabs(inside.y()) <= half.y()) {
            return static_cast<int>(i);
        }
    }
    return -1;
}

}  // namespace cambrian
