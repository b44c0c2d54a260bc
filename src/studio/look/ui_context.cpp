#include "studio/look/ui_context.h"

#include "core/assert.h"

#include <imgui_internal.h>

#include <algorithm>

namespace cambrian {
namespace {

constexpr float kSlack = 1.0F;  // pixels by which rounding may cut a control

Rect seen_part(const Rect& rect, const ImRect& window) {
    const float left = std::max(rect.x, window.Min.x);
    const float top = std::max(rect.y, window.Min.y);
    const float right = std::min(rect.x + rect.width, window.Max.x);
    const float foot = std::min(rect.y + rect.height, window.Max.y);
    if (right <= left || foot <= top) return {};
    return {left, top, right - left, foot - top};
}

// Returns whether the window, or one that contains it, can be scrolled along an axis.
bool scrolls(const ImGuiWindow* window, ImGuiAxis axis) {
    const auto index = static_cast<std::size_t>(axis);
    for (; window != nullptr; window = window->ParentWindow) {
        const bool allowed = (window->Flags & ImGuiWindowFlags_NoScrollWithMouse) == 0;
        if (allowed && window->ScrollMax[index] > 0.0F) return true;
        if ((window->Flags & ImGuiWindowFlags_ChildWindow) == 0) return false;
    }
    return false;
}

}  // namespace

UiContext& ui() {
    auto* context = static_cast<UiContext*>(ImGui::GetIO().UserData);
    CAMBRIAN_ASSERT(context != nullptr, "the ImGui host sets io.UserData");
    return *context;
}

bool scrolls_down(const ImGuiWindow* window) {
    return scrolls(window, ImGuiAxis_Y);
}

void note_place(const std::string& name) {
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 size = ImGui::GetItemRectSize();
    note_place(name, {low.x, low.y, size.x, size.y});
}

void note_place(const std::string& name, const Rect& rect) {
    const ImGuiWindow* window = ImGui::GetCurrentWindowRead();
    const Rect seen = seen_part(rect, window->OuterRectClipped);
    const bool narrower = seen.width < rect.width - kSlack && !scrolls(window, ImGuiAxis_X);
    const bool lower = seen.height < rect.height - kSlack && !scrolls_down(window);
    ui().places[name] = {.rect = rect,
                         .seen = seen,
                         .cut = narrower || lower,
                         .window = window->RootWindow->Name,
                         .frame = ImGui::GetFrameCount()};
}

}  // namespace cambrian
