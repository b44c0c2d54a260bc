#include "studio/widgets/creature_tile.h"

#include "pictures/scene/follow_camera.h"
#include "pictures/scene/moment.h"
#include "pictures/scene/scene_builder.h"
#include "pictures/scene/space_being.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace cambrian {
namespace {

std::array<Vec2, 4> corners_of(double x, double y) {
    return {Vec2(-x, -y), Vec2(x, -y), Vec2(x, y), Vec2(-x, y)};
}

Vec2 corner_of(const PlannedPart& part, const Vec2& corner) {
    return transform(part.rest_pose, {corner.x(), corner.y(), 0.0}).head<2>();
}

Bounds bounds_at_rest(const BodyPlan& plan) {
    Bounds bounds;
    for (const PlannedPart& part : plan.parts) {
        for (const Vec2& corner : corners_of(part.half_extents.x(), part.half_extents.y())) {
            const Vec2 at = corner_of(part, corner);
            bounds.add({at.x(), at.y(), 0.0});
        }
    }
    return bounds;
}

// Returns whether a picture of the living body was drawn.
bool draw_living_tile(ImDrawList& list, const Rect& area, const Phenotype& phenotype, double hue,
                      std::uint64_t line, const TileMoment* moment = nullptr) {
    if (!ui().tile_of) return false;
    if (ui().look == LookMode::kMechanics && !lives_in_space(phenotype)) return false;
    const ImVec2 low = {std::floor(area.x), std::floor(area.y)};
    const int width = static_cast<int>(area.width);
    const int height = static_cast<int>(area.height);
    if (width < 1 || height < 1) return false;
    const auto picture =
        ui().tile_of({phenotype, hue, line_or_hue(line, hue), width, height, moment});
    if (!picture) return false;
    list.AddImage(picture->texture, low,
                  {low.x + static_cast<float>(width), low.y + static_cast<float>(height)},
                  picture->from, picture->to);
    return true;
}

}  // namespace

void draw_creature_tile(ImDrawList& list, const Rect& area, const Phenotype& phenotype, double hue,
                        std::uint64_t line) {
    if (draw_living_tile(list, area, phenotype, hue, line)) return;
    const Bounds bounds = bounds_at_rest(phenotype.plan);
    const Vec3 size = bounds.high - bounds.low;
    const Vec3 middle = 0.5 * (bounds.low + bounds.high);
    constexpr double most_scale = 60.0;  // pixels per metre, before the display's scale
    const double scale = std::min({static_cast<double>(area.width) / std::max(0.01, size.x()),
                                   static_cast<double>(area.height) / std::max(0.01, size.y()),
                                   most_scale * static_cast<double>(ui().scale)});
    for (std::size_t i = phenotype.plan.parts.size(); i-- > 0;) {
        const PlannedPart& part = phenotype.plan.parts[i];
        std::array<ImVec2, 4> outline;
        const auto corners = corners_of(part.half_extents.x(), part.half_extents.y());
        for (std::size_t c = 0; c < outline.size(); ++c) {
            const Vec2 at = corner_of(part, corners[c]);
            outline[c] = {area.center().x + static_cast<float>((at.x() - middle.x()) * scale),
                          area.center().y - static_cast<float>((at.y() - middle.y()) * scale)};
        }
        const Color color = part_color(phenotype.parts[i], hue);
        // Dear ImGui fills polygons that are clockwise on the screen.
        std::reverse(outline.begin(), outline.end());
        list.AddConvexPolyFilled(outline.data(), 4, paint(color));
        list.AddPolyline(outline.data(), 4, paint(mix(color, color_of(0x000000), 0.4F)),
                         ImDrawFlags_Closed, 1.0F);
    }
}

void draw_moving_tile(ImDrawList& list, const Rect& area, const RecordedMotion& motion,
                      const Individual& creature, double time, bool walks) {
    if (motion.empty()) return;
    constexpr double kShare = 0.92;  // of the tile, for the body
    const Viewport size{static_cast<double>(area.width), static_cast<double>(area.height)};
    const MotionFrame shown = motion.at(time);
    TileMoment moment{shown.poses, shown.stretches, character_of(motion, walks, time), {}, {}};
    Camera& camera = moment.camera;
    camera.pixels_per_metre = scale_to_fit(motion, {0.0, 0.0, size.width, size.height}, kShare);
    camera.center = shown.center_of_mass.head<2>();
    moment.middle = shown.center_of_mass;
    // The ground stays at the lower edge.
    const double half = 0.5 * size.height * camera.pixel();
    if (walks) {
        const double highest = body_window(*motion.phenotype, shown.poses).high.y();
        camera.center.y() = std::max(half - 3.0 * camera.pixel(), highest - half);
    }
    const double hue = creature.genome->hue;
    draw_living_tile(list, area, *motion.phenotype, hue, creature.line, &moment);
}

int tiles_across(float room, float width, float gap) {
    return std::max(1, static_cast<int>((room + gap) / (width + gap)));
}

}  // namespace cambrian
