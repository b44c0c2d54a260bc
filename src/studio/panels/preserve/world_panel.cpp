#include "studio/panels/preserve/world_panel.h"

#include "genome/creature_name.h"
#include "pictures/preserve/world_scene.h"
#include "preserve/world_time.h"
#include "studio/frame/help_mark.h"
#include "studio/look/overlays.h"
#include "studio/widgets/panel_keys.h"
#include "studio/widgets/widgets.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace cambrian {
namespace {

constexpr double kChaseLag = 0.25;     // s; time constant with which the camera follows
constexpr double kChaseMargin = 0.06;  // share of the viewport free around a followed creature
constexpr double kLeastSight = 3.0;    // m; least height of a meadow that is in view
constexpr double kWorldShare = 0.97;   // share of the viewport filled by the world
constexpr float kWordsAbove = 36.0F;   // of the words above it, in units of 1/96 inch
constexpr double kPickPixels = 12.0;   // distance at which a click picks a creature
constexpr float kPanStep = 60.0F;      // a press of an arrow key, in units of 1/96 inch

void outlined_text(ImDrawList& list, const ImVec2& at, const Color& color,
                   const std::string& text) {
    const ImVec2 place = {std::round(at.x), std::round(at.y)};
    list.AddText({place.x, place.y + 1.0F}, paint(with_alpha(colors().sky, 0.9F)), text.c_str());
    list.AddText(place, paint(color), text.c_str());
}

// Returns the stretch of a meadow with the most creatures, as high as they need and as wide as the
// viewport is for its height.
WorldWindow most_creatures(const PreservePicture& picture, const Viewport& viewport) {
    std::vector<double> places;
    double top = kLeastSight;
    for (const ResidentPicture& resident : picture.residents) {
        places.push_back(resident.center.x());
        top = std::max(top, resident.center.y() + reach_of(resident));
    }
    std::sort(places.begin(), places.end());
    const double height = std::min(1.5 * top, picture.area.height);
    const double width = std::min(height * viewport.width / viewport.height, picture.area.width);
    std::size_t most = 0;
    double left = places.front();
    for (std::size_t first = 0; first < places.size(); ++first) {
        const auto end = std::upper_bound(places.begin(), places.end(), places[first] + width);
        const auto count = static_cast<std::size_t>(end - places.begin()) - first;
        if (count <= most) continue;
        most = count;
        left = places[first] - 0.5 * (width - (*(end - 1) - places[first]));
    }
    const double ground = picture.area.bottom() - kGroundShare * height;
    return {{left, ground}, {left + width, ground + height}};
}

}  // namespace

void WorldPanel::draw(const FrameContext& frame, Requests& out) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const ImVec2 room = ImGui::GetContentRegionAvail();
    canvas_.area = {at.x, at.y, room.x, room.y};
    canvas_.framebuffer_height = frame.window.framebuffer_height;
    ImGui::InvisibleButton("world", {std::max(1.0F, room.x), std::max(1.0F, room.y)},
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                               ImGuiButtonFlags_MouseButtonMiddle);
    note_place("world");
    ImGui::SetItemAllowOverlap();
    hovered_ = ImGui::IsItemHovered();
    if (hovered_) canvas_.zoom_by_wheel(frame.preserve->follow);
    handle_mouse(frame, out);
    handle_keys(frame, out);
    place_camera(frame);
    aim(out);
    canvas_.frame.clear();
    canvas_.frame.detail = detail_of(frame.window.scenery);
    const PreserveView& preserve = *frame.preserve;
    add_world(canvas_.frame, colors(), canvas_.camera, canvas_.size(), preserve.picture,
              {preserve.picked == nullptr ? 0 : preserve.picked->life.number,
               preserve.pins.creatures, preserve.energy, frame.view.look,
               frame.window.scenery != Scenery::kPlain ? std::optional(daytime_of(frame.view.theme))
                                                       : std::nullopt});
    const ResidentPicture* held = held_ == 0 ? nullptr : preserve.picture.find(held_);
    if (held != nullptr && ImGui::IsMouseDragging(ImGuiMouseButton_Left)) {
        const Vec2 mouse = canvas_.mouse_in_world();
        const Vec2 from = image_near(preserve.picture.area, held->center.head<2>(), mouse);
        canvas_.frame.add_line(from, mouse, 2.0 * canvas_.camera.pixel(), colors().accent);
    }
    draw_wall(preserve.wall);
    canvas_.add_to(*ImGui::GetWindowDrawList());
    draw_labels(frame);
    draw_words(frame);
    ImGui::SetCursorScreenPos({at.x + room.x - px(34), at.y + px(10)});
    help_mark("preserve", out);
}

ImVec2 WorldPanel::on_screen(const Vec2& point) const {
    const Vec2 at = canvas_.camera.to_screen(point, canvas_.size());
    return {canvas_.area.x + static_cast<float>(at.x()),
            canvas_.area.y + static_cast<float>(at.y())};
}

void WorldPanel::place_camera(const FrameContext& frame) {
    const PreserveView& preserve = *frame.preserve;
    Camera& camera = canvas_.camera;
    const WorldArea& area = preserve.picture.area;
    if (std::exchange(fits_seen_, preserve.fits_asked) != preserve.fits_asked) {
        const auto words = static_cast<double>(px(kWordsAbove));
        const Viewport size = canvas_.size();
        const Viewport room = {size.width, std::max(1.0, size.height - 2.0 * words)};
        const bool near = preserve.near && !preserve.picture.residents.empty();
        if (near) {
            camera.fit(most_creatures(preserve.picture, room), 1.0, room);
        } else {
            const Vec2 corner(0.5 * area.width, 0.5 * area.height);
            const Vec2 middle = area.middle().head<2>();
            camera.fit({middle - corner, middle + corner}, kWorldShare, room);
            camera.center = middle_of_view(area, room.height * camera.pixel());
        }
    }
    if (preserve.follow && preserve.picked != nullptr) {
        const Vec2 center = preserve.picked->center.head<2>();
        camera.approach(image_near(area, center, camera.center),
                        static_cast<double>(ImGui::GetIO().DeltaTime), kChaseLag);
        const Vec2 here = image_near(area, center, camera.center);
        const Vec2 reach = Vec2::Constant(reach_of(*preserve.picked));
        camera.keep_in_view({here - reach, here + reach}, kChaseMargin, canvas_.size());
    }
    camera.center = image_near(area, camera.center, Vec2::Zero());
}

void WorldPanel::pan(const ImVec2& pixels, const FrameContext& frame, Requests& out) {
    canvas_.camera.pan({static_cast<double>(pixels.x), static_cast<double>(pixels.y)});
    if (frame.preserve->follow) out.ask(FollowPicked{});
}

void WorldPanel::handle_mouse(const FrameContext& frame, Requests& out) {
    const bool dragged = ImGui::IsItemActive() && (ImGui::IsMouseDragging(ImGuiMouseButton_Right) ||
                                                   ImGui::IsMouseDragging(ImGuiMouseButton_Middle));
    const ImVec2 moved = ImGui::GetIO().MouseDelta;
    if (dragged && (moved.x != 0.0F || moved.y != 0.0F)) pan(moved, frame, out);
    const ImVec2 middle_drag = ImGui::GetMouseDragDelta(ImGuiMouseButton_Middle);
    if (hovered_ && ImGui::IsMouseReleased(ImGuiMouseButton_Middle) && middle_drag.x == 0.0F &&
        middle_drag.y == 0.0F) {
        aim(out);
        out.ask(FeedThere{});
    }
    if (frame.preserve->wall.on || walling_) {
        handle_wall(frame.preserve->wall, out);
    } else {
        handle_left_button(frame, out);
    }
}

// A click sets an end of the wall; a drag sets both.
void WorldPanel::handle_wall(const WallTool& wall, Requests& out) {
    if (hovered_ && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
        walling_ = !wall.from;
        aim(out);
        out.ask(DrawWall{});
    }
    if (!walling_ || ImGui::IsMouseDown(ImGuiMouseButton_Left)) return;
    const ImVec2 drag = ImGui::GetMouseDragDelta(ImGuiMouseButton_Left);
    walling_ = false;
    if (!hovered_ || (drag.x == 0.0F && drag.y == 0.0F)) return;
    aim(out);
    out.ask(DrawWall{});
}

// Shows the wall as it would be built.
void WorldPanel::draw_wall(const WallTool& wall) {
    if (!wall.from) return;
    canvas_.frame.add_line(*wall.from, aim_, std::max(0.2, 2.0 * canvas_.camera.pixel()),
                           with_alpha(colors().accent, 0.7F));
}

// A click picks what is under it, a drag moves a creature or, beginning in the water, the camera.
void WorldPanel::handle_left_button(const FrameContext& frame, Requests& out) {
    const PreservePicture& picture = frame.preserve->picture;
    if (hovered_ && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
        pressed_ = true;
        held_ =
            resident_at(picture, canvas_.mouse_in_world(), kPickPixels * canvas_.camera.pixel());
        if (held_ != 0 || frame.preserve->picked != nullptr) out.ask(PickResident{held_});
    }
    if (!pressed_) return;
    const bool dragging = ImGui::IsMouseDragging(ImGuiMouseButton_Left);
    const ImVec2 moved = ImGui::GetIO().MouseDelta;
    if (dragging && held_ == 0 && (moved.x != 0.0F || moved.y != 0.0F)) pan(moved, frame, out);
    if (ImGui::IsMouseDown(ImGuiMouseButton_Left)) return;
    const ImVec2 drag = ImGui::GetMouseDragDelta(ImGuiMouseButton_Left);
    if (held_ != 0 && hovered_ && (drag.x != 0.0F || drag.y != 0.0F)) {
        aim(out);
        out.ask(MovePickedThere{});
    }
    pressed_ = false;
    held_ = 0;
}

void WorldPanel::handle_keys(const FrameContext& frame, Requests& out) {
    if (frame.covered()) return;
    const float step = px(kPanStep);
    if (panel_key(ImGuiKey_LeftArrow)) pan({step, 0.0F}, frame, out);
    if (panel_key(ImGuiKey_RightArrow)) pan({-step, 0.0F}, frame, out);
    if (panel_key(ImGuiKey_UpArrow)) pan({0.0F, step}, frame, out);
    if (panel_key(ImGuiKey_DownArrow)) pan({0.0F, -step}, frame, out);
    const Viewport size = canvas_.size();
    const Vec2 middle(0.5 * size.width, 0.5 * size.height);
    if (panel_key(ImGuiKey_PageUp)) canvas_.camera.zoom_about(middle, kNotchFactor, size);
    if (panel_key(ImGuiKey_PageDown)) canvas_.camera.zoom_about(middle, 1.0 / kNotchFactor, size);
}

// Food and creatures arrive where the mouse points or, if it does not, in the middle of the view.
void WorldPanel::aim(Requests& out) {
    const Vec2 aimed = hovered_ ? canvas_.mouse_in_world() : canvas_.camera.center;
    if (aimed == aim_) return;
    aim_ = aimed;
    out.ask(AimAt{aimed.x(), aimed.y()});
}

void WorldPanel::draw_labels(const FrameContext& frame) {
    const PreserveView& preserve = *frame.preserve;
    const WithFont font(ui().fonts.small);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const auto label = [&](const ResidentPicture& resident, const Color& color) {
        const ImVec2 center = on_screen(
            image_near(preserve.picture.area, resident.center.head<2>(), canvas_.camera.center));
        const auto reach =
            static_cast<float>(reach_of(resident) * canvas_.camera.pixels_per_metre) + px(16);
        const std::string name =
            fmt::format("{} {}", creature_name(*resident.life.genome), resident.life.number);
        const float width = ImGui::CalcTextSize(name.c_str()).x;
        outlined_text(list, {center.x - 0.5F * width, center.y + reach}, color, name);
    };
    for (const std::uint64_t pin : preserve.pins.creatures) {
        const ResidentPicture* pinned = preserve.picture.find(pin);
        if (pinned != nullptr && !preserve.picked_is(pin)) label(*pinned, colors().text);
    }
    if (preserve.picked == nullptr || preserve.picked->life.died != 0) return;
    label(*preserve.picked, colors().accent);
}

void WorldPanel::draw_words(const FrameContext& frame) const {
    const PreserveView& preserve = *frame.preserve;
    const ImVec2 corner = {canvas_.area.x + px(14), canvas_.area.y + px(10)};
    const float room = canvas_.area.width - px(60);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const std::string name =
        preserve.file.empty() ? "A preserve that is not kept" : preserve.file.stem().string();
    std::string state = world_time(preserve.picture.tick);
    if (preserve.opening) {
        state = "opening…";
    } else if (!preserve.picture.playing) {
        state += "  ·  paused, Space goes on";
    }
    if (preserve.wall.on) {
        state = fmt::format("a wall: W or a click sets its {} end, Esc leaves it",
                            preserve.wall.from ? "other" : "first");
    }
    float named = 0.0F;
    {
        const WithFont font(ui().fonts.strong);
        const std::string shown = fit_text(name, 0.5F * room);
        named = ImGui::CalcTextSize(shown.c_str()).x + px(14);
        outlined_text(list, corner, colors().text, shown);
    }
    const WithFont font(ui().fonts.small);
    outlined_text(list, {corner.x + named, corner.y + px(2)}, colors().muted,
                  fit_text(state, room - named));
}

}  // namespace cambrian
