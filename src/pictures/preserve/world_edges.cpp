#include "pictures/preserve/world_edges.h"

#include <algorithm>
#include <cstdint>

namespace cambrian {

void add_walls(SceneFrame& frame, const Palette& palette, const Camera& camera,
               const Viewport& viewport, const WorldArea& area, bool scenery) {
    const WorldWindow window = camera.window(viewport);
    const double right = 0.5 * area.width;
    const double top = area.top();
    const double bottom = area.bottom();
    constexpr double kWallPixels = 3.0;
    const double wall = kWallPixels * camera.pixel();
    const auto fill = [&](double x0, double y0, double x1, double y1, const Color& color) {
        const Vec2 low(std::max(x0, window.low.x() - wall), std::max(y0, window.low.y() - wall));
        const Vec2 high(std::min(x1, window.high.x() + wall), std::min(y1, window.high.y() + wall));
        if (low.x() < high.x() && low.y() < high.y())
            frame.add_box(0.5 * (low + high), 0.5 * (high - low), color);
    };
    constexpr double kFar = 1e6;
    const double end = area.has_sides() ? right : kFar;  // of the top and the bottom
    // Scenery shows the ground, and ground with a shape is drawn by itself.
    const bool has_floor = area.has_ground ? !scenery && !area.ground : area.has_bottom();
    if (area.has_sides()) {
        fill(-kFar, -kFar, -right, kFar, palette.window);
        fill(right, -kFar, kFar, kFar, palette.window);
    }
    // Above a meadow is more of its sky.
    const bool open_sky = scenery && area.has_ground;
    if (area.has_top() && !open_sky) fill(-kFar, top, kFar, kFar, palette.window);
    if (has_floor)
        fill(-kFar, -kFar, kFar, bottom, area.has_ground ? palette.ground : palette.window);
    if (area.has_sides()) {
        fill(-right - wall, area.foot_at(-right) - wall, -right, top + wall, palette.ground_line);
        fill(right, area.foot_at(right) - wall, right + wall, top + wall, palette.ground_line);
    }
    if (area.has_top() && !open_sky) fill(-end, top, end, top + wall, palette.ground_line);
    if (has_floor) fill(-end, bottom - wall, end, bottom, palette.ground_line);
}

void add_seams(SceneFrame& frame, const Palette& palette, const Camera& camera,
               const WorldArea& area) {
    const Vec2 corner(area.left(), area.foot_at(area.left()));
    const auto line = [&](const Vec2& to) {
        frame.add_line(corner, to, camera.pixel(), palette.ground_line);
    };
    if (!area.has_sides()) line({area.left(), area.top()});
    if (!area.has_top()) line({-area.left(), corner.y()});
}

std::vector<Vec2> image_shifts(const WorldArea& area) {
    const Torus torus = area.torus();
    std::vector<Vec2> shifts = {Vec2::Zero()};
    for (std::int32_t y = -1; y <= 1; ++y) {
        for (std::int32_t x = -1; x <= 1; ++x) {
            const Vec3 shift = torus.shift_of({x, y});
            const bool is_image = (x == 0 || shift.x() != 0.0) && (y == 0 || shift.y() != 0.0);
            if (is_image && (x != 0 || y != 0)) shifts.push_back(shift.head<2>());
        }
    }
    return shifts;
}

bool in_view(const Vec2& center, double reach, const WorldWindow& window) {
    return center.x() + reach > window.low.x() && center.x() - reach < window.high.x() &&
           center.y() + reach > window.low.y() && center.y() - reach < window.high.y();
}

namespace {

// Adds a skin again, moved, if it is in view there.
void repeat_skin(SceneFrame& frame, Skin skin, const Vec2& shift, const WorldWindow& window) {
    const std::size_t end = skin.first_box + skin.boxes;
    const auto seen = [&](std::size_t box) {
        const SkinBox& each = frame.skin_boxes[box];
        return in_view(each.center + shift, each.half_extents.norm() + skin.blend, window);
    };
    bool any = false;
    for (std::size_t box = skin.first_box; box < end; ++box)
        any = any || seen(box);
    if (!any) return;
    for (std::size_t box = skin.first_box; box < end; ++box) {
        SkinBox moved = frame.skin_boxes[box];
        moved.center += shift;
        frame.skin_boxes.push_back(moved);
    }
    frame.add_skin(skin);
}

}  // namespace

void repeat_from(std::size_t first, SceneFrame& frame, const WorldWindow& window,
                 std::span<const Vec2> shifts) {
    const std::size_t end = frame.shapes.size();
    const std::size_t skins = frame.skins.size();
    for (const Vec2& shift : shifts.subspan(1)) {
        std::size_t skin = 0;
        const auto repeat_skins_below = [&](std::size_t shape) {
            for (; skin < skins && frame.skins[skin].shapes_below <= shape; ++skin) {
                if (frame.skins[skin].shapes_below >= first)
                    repeat_skin(frame, frame.skins[skin], shift, window);
            }
        };
        for (std::size_t i = first; i < end; ++i) {
            repeat_skins_below(i);
            Shape shape = frame.shapes[i];
            shape.center += shift;
            const double reach = shape.half_extents.norm() + shape.blur;
            if (in_view(shape.center, reach, window)) frame.shapes.push_back(shape);
        }
        repeat_skins_below(end);
    }
}

}  // namespace cambrian
