#include "render/scene_frame.h"

#include <algorithm>
#include <cmath>

namespace cambrian {

void SceneFrame::add_box(const Vec2& center, const Vec2& half_extents, const Color& fill) {
    shapes.push_back({.center = center, .half_extents = half_extents, .fill = fill});
}

void SceneFrame::add_line(const Vec2& from, const Vec2& to, double width, const Color& color) {
    const Vec2 along = to - from;
    const double half_width = 0.5 * width;
    shapes.push_back({.center = 0.5 * (from + to),
                      .half_extents = {0.5 * along.norm() + half_width, half_width},
                      .angle = std::atan2(along.y(), along.x()),
                      .radius = half_width,
                      .fill = color});
}

void SceneFrame::add_circle(const Vec2& center, double radius, const Color& fill) {
    shapes.push_back(
        {.center = center, .half_extents = {radius, radius}, .radius = radius, .fill = fill});
}

void SceneFrame::add_ring(const Vec2& center, double radius, double width, const Color& color) {
    shapes.push_back({.center = center,
                      .half_extents = {radius, radius},
                      .radius = radius,
                      .outline_width = width,
                      .fill = with_alpha(color, 0.0F),
                      .outline = color});
}

void SceneFrame::add_glow(const Vec2& center, double radius, const Color& color) {
    shapes.push_back({.center = center,
                      .half_extents = Vec2::Constant(0.5 * radius),
                      .radius = 0.5 * radius,
                      .blur = 0.5 * radius,
                      .fill = color});
}

void SceneFrame::add_arc(const Vec2& center, double radius, const std::array<double, 2>& angles,
                         double width, const Color& color) {
    constexpr double longest = 0.2;  // rad; longest arc drawn as a straight line
    const double turn = angles[1] - angles[0];
    const int pieces = std::max(1, static_cast<int>(std::ceil(std::fabs(turn) / longest)));
    const auto point = [&](int i) {
        const double angle = angles[0] + turn * i / pieces;
        return Vec2(center + radius * Vec2(std::cos(angle), std::sin(angle)));
    };
    for (int i = 0; i < pieces; ++i)
        add_line(point(i), point(i + 1), width, color);
}

void SceneFrame::add_trail(std::span<const Vec2> points, double dot_radius, const Color& color) {
    const auto count = static_cast<float>(points.size());
    float age = count;
    for (const Vec2& point : points) {
        const float share = 1.0F - age / count;
        add_circle(point, dot_radius, with_alpha(color, color.a * share));
        age -= 1.0F;
    }
}

void SceneFrame::add_skin(Skin skin) {
    skin.shapes_below = shapes.size();
    skin.first_box = skin_boxes.size() - skin.boxes;
    skins.push_back(skin);
}

void SceneFrame::clear() {
    backdrop = nullptr;
    shapes.clear();
    skins.clear();
    skin_boxes.clear();
    light = {};
    space = nullptr;
    detail = Detail::kFull;
    ground = {};
}

double GroundShape::at(double x) const {
    if (surface.empty()) return 0.0;
    const auto after =
        std::upper_bound(surface.begin(), surface.end(), x,
                         [](double value, const Vec2& point) { return value < point.x(); });
    if (after == surface.begin()) return surface.front().y();
    if (after == surface.end()) return surface.back().y();
    const Vec2& to = *after;
    const Vec2& from = *(after - 1);
    return from.y() + (x - from.x()) / (to.x() - from.x()) * (to.y() - from.y());
}

}  // namespace cambrian
