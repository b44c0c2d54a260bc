#include "studio/widgets/value_slider.h"

#include "core/text/pretty_text.h"
#include "studio/look/ui_context.h"
#include "studio/widgets/keyboard_focus.h"
#include "studio/widgets/typed_number.h"

#include <fmt/core.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

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

// Returns the unit that follows the number in a printf pattern.
std::string unit_of(const std::string& pattern) {
    const std::size_t end = pattern.find_first_of("dfg", pattern.find('%'));
    std::string unit = end == std::string::npos ? "" : pattern.substr(end + 1);
    return unit.starts_with(' ') ? unit.substr(1) : unit;
}

// Returns the number that was typed; an error says why the slider cannot have it.
template <class Number>
Result<Number> accepted(const std::string& text, const SliderStyle& style) {
    const Result<double> typed = typed_number(text, unit_of(style.pattern));
    if (!typed) return typed.error();
    if (std::is_integral_v<Number> && *typed != std::floor(*typed))
        return Error{fmt::format("{} is not a whole number.", text)};
    const SliderRange limits = style.allowed.value_or(
        SliderRange{static_cast<double>(std::numeric_limits<Number>::lowest()),
                    static_cast<double>(std::numeric_limits<Number>::max())});
    if (*typed < limits.low || *typed > limits.high)
        return Error{fmt::format("{} is not allowed here; {} to {} is.", text,
                                 pretty_number(limits.low), pretty_number(limits.high))};
    return static_cast<Number>(*typed);
}

// Draws the text field in place of the slider into which a number is being typed. Dear ImGui's own
// drops letters that it does not expect, which makes 15 of "1,5".
template <class Number>
void draw_typing(ImGuiID slider, ImGuiDataType type, const Number& value, const SliderStyle& style,
                 const char* pattern) {
    std::array<char, 64> text{};
    std::optional<TypedText>& typed = ui().typed;
    if (!typed || typed->slider != slider) {
        std::array<char, 32> number{};
        pattern = ImParseFormatTrimDecorations(pattern, number.data(), number.size());
        ImGui::DataTypeFormatString(text.data(), static_cast<int>(text.size()), type, &value,
                                    pattern);
        ImStrTrimBlanks(text.data());
        typed = TypedText{slider, text.data()};
    } else {
        typed->text.copy(text.data(), text.size() - 1);
    }
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImRect box(low, {low.x + style.width, low.y + ImGui::GetFrameHeight()});
    ImGui::ItemSize(box, ImGui::GetStyle().FramePadding.y);
    if (!ImGui::ItemAdd(box, slider, &box, ImGuiItemFlags_Inputable)) return;
    typed->changed |=
        ImGui::TempInputText(box, slider, "##value", text.data(), static_cast<int>(text.size()),
                             ImGuiInputTextFlags_AutoSelectAll);
    typed->text = text.data();
}

// A typed number counts only when complete, since typing "0.9" passes through "0", and only for the
// slider it was typed into.
template <class Number>
bool when_complete(ImGuiID slider, bool edited, Number before, Number& value,
                   const SliderStyle& style) {
    if (ImGui::TempInputIsActive(slider)) {
        value = before;
        return false;
    }
    std::optional<TypedText>& typed = ui().typed;
    if (!typed || typed->slider != slider || !ImGui::IsItemDeactivated()) return edited;
    const TypedText entered = *std::exchange(typed, std::nullopt);
    value = before;
    const bool given_up = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
    if (given_up || !entered.changed) return false;
    const Result<Number> number = accepted<Number>(entered.text, style);
    if (!number) {
        ui().complaint = number.error().message + " The value stays as it was.";
        return false;
    }
    value = *number;
    return value != before;
}

// Draws Dear ImGui's slider over the bar, without its own frame and handle.
template <class Number>
bool draw_slider(ImGuiDataType type, Number& value, const SliderStyle& style, const char* pattern) {
    draw_slider_back(slider_share(style, static_cast<double>(value)), style.width);
    constexpr std::array slots = {ImGuiCol_FrameBg, ImGuiCol_FrameBgHovered, ImGuiCol_FrameBgActive,
                                  ImGuiCol_SliderGrab, ImGuiCol_SliderGrabActive};
    for (const ImGuiCol slot : slots)
        ImGui::PushStyleColor(slot, paint(with_alpha(colors().raised, 0.0F)));
    ImGui::SetNextItemWidth(style.width);
    const auto low = static_cast<Number>(style.range.low);
    const auto high = static_cast<Number>(style.range.high);
    const bool edited = ImGui::SliderScalar("##value", type, &value, &low, &high, pattern,
                                            style.logarithmic ? ImGuiSliderFlags_Logarithmic : 0);
    ImGui::PopStyleColor(static_cast<int>(slots.size()));
    return edited;
}

template <class Number>
bool bare_slider(ImGuiDataType type, Number& value, const SliderStyle& style, const char* pattern) {
    const ImGuiID slider = ImGui::GetID("##value");
    const Number before = value;
    bool edited = false;
    if (ImGui::TempInputIsActive(slider)) {
        draw_typing(slider, type, value, style, pattern);
    } else {
        edited = draw_slider(type, value, style, pattern);
    }
    focus_stop_for_text();
    return when_complete(slider, edited, before, value, style);
}

}  // namespace

bool value_slider(double& value, const SliderStyle& style) {
    return bare_slider(ImGuiDataType_Double, value, style, style.pattern.c_str());
}

bool value_slider(int& value, const SliderStyle& style) {
    return bare_slider(ImGuiDataType_S32, value, style, "%d");
}

}  // namespace cambrian
