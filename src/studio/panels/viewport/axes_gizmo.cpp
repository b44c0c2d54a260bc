#include "studio/panels/viewport/axes_gizmo.h"

#include "studio/panels/viewport/space_overlays.h"
#include "studio/widgets/widgets.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace cambrian {
namespace {

constexpr std::array kNames = {"x", "y", "z"};

struct AxisEnd {
    Vec3 side;  // the direction of the axis
    int axis = 0;
    bool positive = true;
    ImVec2 place;       // in the window
    double near = 0.0;  // how near it is to the camera
};

std::array<AxisEnd, 6> ends_of(const SpaceCamera& camera, const ImVec2& middle) {
    std::array<AxisEnd, 6> ends;
    for (std::size_t i = 0; i < ends.size(); ++i) {
        AxisEnd& end = ends[i];
        end.axis = static_cast<int>(i / 2);
        end.positive = i % 2 == 0;
        end.side = (end.positive ? 1.0 : -1.0) * Vec3::Unit(end.axis);
        const auto reach = px(0.36F * kGizmoSide);
        end.place = {middle.x + reach * static_cast<float>(end.side.dot(camera.right)),
                     middle.y - reach * static_cast<float>(end.side.dot(camera.up))};
        end.near = end.side.dot(camera.back);
    }
    std::sort(ends.begin(), ends.end(),
              [](const AxisEnd& a, const AxisEnd& b) { return a.near < b.near; });
    return ends;
}

// Returns the nearest end under the mouse, or null.
const AxisEnd* end_under_mouse(const std::array<AxisEnd, 6>& ends) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const auto under = [&mouse](const AxisEnd& end) {
        return std::hypot(end.place.x - mouse.x, end.place.y - mouse.y) < px(10);
    };
    const auto found = std::find_if(ends.rbegin(), ends.rend(), under);
    return found == ends.rend() ? nullptr : &*found;
}

}  // namespace

void draw_axes_gizmo(OrbitCamera& camera, const ImVec2& middle) {
    const float side = px(kGizmoSide);
    ImGui::SetCursorScreenPos({middle.x - 0.5F * side, middle.y - 0.5F * side});
    ImGui::InvisibleButton("axes", {side, side});
    note_place("axes");
    const bool active = ImGui::IsItemActive();
    const bool hovered = ImGui::IsItemHovered() || active;
    const std::array<AxisEnd, 6> ends = ends_of(camera.seen({1.0, 1.0}), middle);
    const AxisEnd* under = ImGui::IsItemHovered() ? end_under_mouse(ends) : nullptr;
    const bool dragged = ImGui::IsMouseDragging(ImGuiMouseButton_Left, 3.0F);
    if (active && dragged) {
        const ImVec2 moved = ImGui::GetIO().MouseDelta;
        camera.orbit({static_cast<double>(moved.x), static_cast<double>(moved.y)});
    }
    const ImVec2 drag = ImGui::GetMouseDragDelta(ImGuiMouseButton_Left, 3.0F);
    if (ImGui::IsItemDeactivated() && drag.x == 0.0F && drag.y == 0.0F && under != nullptr)
        camera.look_from(under->side);
    tooltip("A click on an end looks along that axis, and a drag goes round");
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (hovered)
        list.AddCircleFilled(middle, 0.5F * side, paint(with_alpha(colors().panel, 0.45F)));
    for (const AxisEnd& end : ends) {
        const auto shade = static_cast<float>(0.5 + 0.5 * (0.5 + 0.5 * end.near));
        const Color color = with_alpha(axis_color(end.axis), shade);
        if (end.positive) {
            list.AddLine(middle, end.place, paint(color), px(2));
            list.AddCircleFilled(end.place, px(8), paint(color), 20);
            const WithFont font(ui().fonts.small);
            const char* name = kNames[static_cast<std::size_t>(end.axis)];
            const ImVec2 size = ImGui::CalcTextSize(name);
            list.AddText(
                {std::round(end.place.x - 0.5F * size.x), std::round(end.place.y - 0.54F * size.y)},
                paint(color_of(0x14171C)), name);
        } else {
            list.AddCircleFilled(end.place, px(6), paint(with_alpha(color, 0.35F * shade)), 16);
            list.AddCircle(end.place, px(6), paint(color), 16, px(1.5F));
        }
        if (under == &end) list.AddCircle(end.place, px(10), paint(colors().text), 20, px(1.5F));
    }
}

}  // namespace cambrian
