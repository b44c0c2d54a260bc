#include "studio/layout.h"

#include <algorithm>
#include <cmath>

namespace cambrian {
namespace {

constexpr float kPanelGap = 2.0F;
constexpr float kBarHeight = 54.0F;
constexpr float kTransportHeight = 58.0F;
constexpr float kFootHeight = 28.0F;
constexpr float kNarrowWidth = 780.0F;
constexpr float kLowHeight = 500.0F;

struct SizeLimits {
    float least;
    float usual_most;  // the most when it follows the window's size
    float most;        // the most when set by the user
};

float panel_size(bool shown, float by_hand, float usual, const SizeLimits& limits, float scale) {
    if (!shown) return 0.0F;
    if (by_hand > 0.0F) {
        return std::clamp(by_hand * scale, 0.75F * limits.least,
                          std::max(limits.most, limits.least));
    }
    return std::clamp(usual, limits.least, limits.usual_most);
}

// A strip that can be dragged along one axis. Returns the distance dragged in this frame, in
// pixels.
float drag_strip(const char* name, const Rect& strip, bool sideways) {
    if (strip.width < 1.0F || strip.height < 1.0F) return 0.0F;
    ImGui::SetNextWindowPos(strip.low());
    ImGui::SetNextWindowSize({strip.width, strip.height});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1, 1));
    ImGui::Begin(name, nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoSavedSettings);
    ImGui::InvisibleButton("gap", {strip.width, strip.height});
    note_place(name);
    const bool held = ImGui::IsItemActive();
    if (held || ImGui::IsItemHovered()) {
        ImGui::SetMouseCursor(sideways ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
        ImGui::GetWindowDrawList()->AddRectFilled(strip.low(), strip.high(),
                                                  paint(with_alpha(colors().accent, 0.5F)));
    }
    ImGui::End();
    ImGui::PopStyleVar(2);
    const ImVec2 moved = ImGui::GetIO().MouseDelta;
    return held ? sideways ? moved.x : moved.y : 0.0F;
}

}  // namespace

bool is_narrow(float width, float scale) {
    return width < kNarrowWidth * scale;
}

Layout divide_window(float width, float height, const ViewState& view, float scale,
                     bool with_foot) {
    const float gap = std::round(kPanelGap * scale);
    if (with_foot) {
        const float foot = std::round(kFootHeight * scale);
        Layout layout = divide_window(width, height - foot - gap, view, scale);
        layout.foot = {0, height - foot, width, foot};
        return layout;
    }
    const float left = panel_size(view.panels.left, view.panels.left_width, 0.25F * width,
                                  {270 * scale, 350 * scale, 0.4F * width}, scale);
    const bool right_shown = view.panels.right && !(left > 0.0F && is_narrow(width, scale));
    const float right = panel_size(right_shown, view.panels.right_width, 0.225F * width,
                                   {260 * scale, 360 * scale, 0.4F * width}, scale);
    const float bottom = panel_size(
        view.panels.bottom, view.panels.bottom_height, 0.26F * height,
        {(height < kLowHeight * scale ? 120.0F : 176.0F) * scale, 270 * scale, 0.5F * height},
        scale);
    const float left_edge = std::round(left > 0 ? left + gap : 0);
    const float right_edge = std::round(right > 0 ? width - right : width + gap);
    const float bottom_edge = std::round(bottom > 0 ? height - bottom : height + gap);
    const float top = std::round(kBarHeight * scale) + gap;
    const float transport = std::round(kTransportHeight * scale);

    Layout layout;
    layout.bar = {0, 0, width, top - gap};
    const float middle_height = bottom_edge - gap - top;
    layout.experiment = {0, top, std::max(0.0F, left_edge - gap), middle_height};
    const float center_width = right_edge - gap - left_edge;
    layout.viewport = {left_edge, top, center_width, middle_height - transport};
    layout.transport = {left_edge, top + middle_height - transport, center_width, transport};
    layout.inspector = {right_edge, top, std::max(0.0F, width - right_edge), middle_height};
    const float bottom_height = std::max(0.0F, height - bottom_edge);
    const float split = std::round(0.5F * width);
    layout.timeline = {0, bottom_edge, split - gap, bottom_height};
    layout.population = {split, bottom_edge, width - split, bottom_height};
    return layout;
}

Layout viewer_layout(float width, float height, float scale) {
    const float transport = std::round(kTransportHeight * scale);
    Layout layout;
    layout.viewport = {0, 0, width, height - transport};
    layout.transport = {0, height - transport, width, transport};
    return layout;
}

bool drag_gaps(const Layout& layout, ViewState& view) {
    const float scale = ui().scale;
    const float thick = px(6);
    const Rect& left = layout.experiment;
    const Rect& right = layout.inspector;
    const Rect& bottom = layout.timeline;
    const float beside = drag_strip(
        "gap left",
        {left.x + left.width - 0.5F * thick, left.y, left.width > 0 ? thick : 0, left.height},
        true);
    const float across = drag_strip(
        "gap right", {right.x - thick, right.y, right.width > 0 ? thick : 0, right.height}, true);
    const float above =
        drag_strip("gap bottom",
                   {0, bottom.y - thick, layout.bar.width, bottom.height > 0 ? thick : 0}, false);
    if (beside != 0.0F) view.panels.left_width = (left.width + beside) / scale;
    if (across != 0.0F) view.panels.right_width = (right.width - across) / scale;
    if (above != 0.0F) view.panels.bottom_height = (bottom.height - above) / scale;
    return beside != 0.0F || across != 0.0F || above != 0.0F;
}

void draw_gaps(const Layout& layout) {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const ImU32 color = paint(colors().window);
    const float gap = std::round(kPanelGap * ui().scale);
    const Rect& bar = layout.bar;
    const auto fill = [&](float x, float y, float width, float height) {
        if (width > 0.0F && height > 0.0F)
            list.AddRectFilled({x, y}, {x + width, y + height}, color);
    };
    const Rect& middle = layout.viewport;
    const float middle_height = middle.height + layout.transport.height;
    fill(0, bar.height, bar.width, gap);
    fill(middle.x - gap, middle.y, gap, middle_height);
    fill(middle.x + middle.width, middle.y, gap, middle_height);
    fill(0, layout.timeline.y - gap, bar.width, layout.timeline.height > 0.0F ? gap : 0.0F);
    fill(0, layout.foot.y - gap, layout.foot.width, gap);
    fill(layout.population.x - gap, layout.population.y, gap, layout.population.height);
}

void begin_place(const char* name, const Rect& rect, float padding_x, float padding_y) {
    constexpr ImGuiWindowFlags flags =
        ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoResize |
        ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
        ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoFocusOnAppearing |
        ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse;
    ImGui::SetNextWindowPos(rect.low());
    ImGui::SetNextWindowSize({rect.width, rect.height});
    const ImVec2 usual = ImGui::GetStyle().WindowPadding;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(padding_x < 0 ? usual.x : padding_x,
                                                            padding_y < 0 ? usual.y : padding_y));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1, 1));
    ImGui::Begin(name, nullptr, flags);
    note_place(std::string("panel ") + name, rect);
    ImGui::PopStyleVar(2);
}

void end_place() {
    ImGui::End();
}

}  // namespace cambrian
