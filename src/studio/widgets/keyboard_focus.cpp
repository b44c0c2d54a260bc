#include "studio/widgets/keyboard_focus.h"

#include <imgui_internal.h>

#include <algorithm>
#include <utility>

namespace cambrian {
namespace {

void add_stop() {
    KeyboardFocus& focus = ui().focus;
    const ImGuiWindow* root = ImGui::GetCurrentWindowRead()->RootWindow;
    if (focus.layer != nullptr && focus.layer != root) return;
    focus.stops.push_back(ImGui::GetItemID());
}

bool has_ring() {
    const ImGuiID item = ImGui::GetItemID();
    return item != 0 && (item == ui().focus.control);
}

void draw_ring() {
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    const float out = px(1);
    const Rect rect = {low.x - out, low.y - out, high.x - low.x + 2 * out,
                       high.y - low.y + 2 * out};
    ImGui::GetWindowDrawList()->AddRect(rect.low(), rect.high(), paint(colors().accent), px(6),
                                        ImDrawFlags_None, px(2));
    note_place("## keyboard focus", rect);
}

// Brings the control that was just reached into sight.
void follow() {
    if (ui().focus.arrived && !ImGui::IsItemVisible()) ImGui::SetScrollHereY();
}

int arrow_steps() {
    const auto pressed = [](ImGuiKey key) {
        const int index = ImGui::GetKeyIndex(key);
        return index >= 0 && ImGui::IsKeyPressed(index) ? 1 : 0;
    };
    return pressed(ImGuiKey_DownArrow) - pressed(ImGuiKey_UpArrow);
}

}  // namespace

bool popup_open() {
    return ImGui::GetCurrentContext()->OpenPopupStack.Size > 0;
}

void begin_focus_frame(int steps) {
    KeyboardFocus& focus = ui().focus;
    const std::vector<ImGuiID> stops = std::exchange(focus.stops, {});
    focus.layer = nullptr;
    focus.arrived = false;
    const int escape = ImGui::GetKeyIndex(ImGuiKey_Escape);
    if (ImGui::GetIO().MouseDown[0] || (escape >= 0 && ImGui::IsKeyPressed(escape, false)))
        focus.control = 0;
    if (steps == 0 && popup_open()) steps = arrow_steps();
    if (steps == 0 || stops.empty()) return;
    const ImGuiID active = ImGui::GetActiveID();
    auto here = std::find(stops.begin(), stops.end(), active);
    if (here == stops.end()) here = std::find(stops.begin(), stops.end(), focus.control);
    const auto count = static_cast<int>(stops.size());
    int next = steps > 0 ? steps - 1 : count + steps;
    if (here != stops.end()) next = static_cast<int>(here - stops.begin()) + steps;
    focus.control = stops[static_cast<std::size_t>(((next % count) + count) % count)];
    focus.arrived = true;
    focus.text = false;
    if (active != 0) ImGui::ClearActiveID();
}

void begin_focus_layer() {
    ui().focus.stops.clear();
    ui().focus.layer = ImGui::GetCurrentWindowRead()->RootWindow;
}

bool focus_stop() {
    add_stop();
    if (!has_ring()) return false;
    ui().focus.text = false;
    draw_ring();
    follow();
    const int enter = ImGui::GetKeyIndex(ImGuiKey_Enter);
    return enter >= 0 && ImGui::GetActiveID() == 0 && ImGui::IsKeyPressed(enter, false);
}

void focus_stop_for_text() {
    add_stop();
    if (ImGui::IsItemActive()) {
        ui().focus.control = ImGui::GetItemID();
        ui().focus.text = true;
        draw_ring();
    } else if (has_ring()) {
        follow();
        // The ring goes with the keyboard when the text is complete.
        if (ui().focus.arrived) {
            ImGui::SetKeyboardFocusHere(-1);
        } else if (ImGui::IsItemDeactivated()) {
            ui().focus.control = 0;
        }
    }
}

bool control_focused() {
    return ui().focus.control != 0 && !ui().focus.text;
}

}  // namespace cambrian
