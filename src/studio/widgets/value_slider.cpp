#include "studio/widgets/value_slider.h"

#include "studio/look/ui_context.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace cambrian {
namespace {

// Returns a value's position on a slider, from 0 to 1, on Dear ImGui's scale.
float slider_share(const SliderStyle& style, double value) {
    const SliderRange& range = style.range;
    const double inside = std::clamp(value, range.low, range.high);
    if (style.logarithmic && range.low > 0.0) {
        return static_cast<float>(std::log(inside / range.low) / std::log(range.high / range.low));
    }
    return static_cast<float>((inside - range.low) / (range.high - range.low));
}

void draw_slider_back(float share, float width) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImVec2 high = {low.x + width, low.y + ImGui::GetFrameHeight()};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(low, high, paint(colors().raised), px(5));
    const float fill = share * width;
    if (fill < px(2)) return;
    list.PushClipRect(low, {low.x + fill, high.y}, true);
    list.AddRectFilled(low, high, paint(mix(colors().raised, colors().accent, 0.38F)), px(5));
    list.PopClipRect();
}

// A typed number counts only when complete, since typing "0.9" passes through "0", and only for the
// slider it was typed into.
template <class Number>
bool when_complete(ImGuiID slider, bool edited, Number before, Number& value) {
    std::optional<TypedNumber>& typed = ui().typed;
    const bool own = typed && typed->slider == slider;
    if (own && ImGui::IsItemActivated()) typed.reset();
    if (edited && ImGui::IsItemActive() && ImGui::GetIO().WantTextInput) {
        typed = TypedNumber{slider, static_cast<double>(value)};
        value = before;
        return false;
    }
    if (!own || !ImGui::IsItemDeactivated()) return edited;
    const bool given_up = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
    value = given_up ? before : static_cast<Number>(typed->value);
    typed.reset();
    return value != before;
}

// Draws Dear ImGui's slider over the bar, without its own frame and handle.
template <class Number>
bool bare_slider(ImGuiDataType type, Number& value, const SliderStyle& style, const char* pattern) {
    draw_slider_back(slider_share(style, static_cast<double>(value)), style.width);
    constexpr std::array slots = {ImGuiCol_FrameBg, ImGuiCol_FrameBgHovered, ImGuiCol_FrameBgActive,
                                  ImGuiCol_SliderGrab, ImGuiCol_SliderGrabActive};
    for (const ImGuiCol slot : slots)
        ImGui::PushStyleColor(slot, paint(with_alpha(colors().raised, 0.0F)));
    ImGui::SetNextItemWidth(style.width);
    const Number before = value;
    const auto low = static_cast<Number>(style.range.low);
    const auto high = static_cast<Number>(style.range.high);
    const bool edited = ImGui::SliderScalar("##value", type, &value, &low, &high, pattern,
                                            style.logarithmic ? ImGuiSliderFlags_Logarithmic : 0);
    ImGui::PopStyleColor(static_cast<int>(slots.size()));
    return when_complete(ImGui::GetID("##value"), edited, before, value);
}

}  // namespace

bool value_slider(double& value, const SliderStyle& style) {
    return bare_slider(ImGuiDataType_Double, value, style, style.pattern.c_str());
}

bool value_slider(int& value, const SliderStyle& style) {
    return bare_slider(ImGuiDataType_S32, value, style, "%d");
}

}  // namespace cambrian
