#include "studio/panels/experiment/setting_row.h"

#include "core/text/parsed_number.h"
#include "core/text/pretty_text.h"
#include "evolution/fields/setting_words.h"
#include "studio/experiment/settings_editor.h"
#include "studio/widgets/widgets.h"

#include <fmt/core.h>
#include <fmt/printf.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace cambrian {
namespace {

constexpr float kLabelShare = 0.5F;
constexpr float kLeastControl = 112.0F;  // width that names leave to the control in narrow panels
constexpr float kLabelMargin = 20.0F;    // width around a label: its mark and a gap

std::string help_text(const SettingField& field, ExperimentSettings& defaults) {
    const std::string name = plain_label(field);
    std::string text = fmt::format("{}{}\n\nDefault {}.", name == field.label ? "" : name + "\n",
                                   field.help, value_text(field, field.at(defaults)));
    if (field.high > field.low && !std::holds_alternative<bool*>(field.at(defaults))) {
        text += fmt::format(" Allowed {} to {}; Ctrl+click to type.", pretty_number(field.low),
                            with_unit(field.high, field.unit));
    }
    if (!field.live) text += "\nDefines the run: a change starts a new one.";
    return text;
}

// Returns printf's pattern with the unit and as many decimals as the range needs.
std::string number_pattern(const SliderRange& range, const SettingField& field) {
    const double width = range.high - range.low;
    std::string number = "%.3f";
    if (field.logarithmic) {
        number = field.low < 100.0 ? "%.2g" : "%.0f";
    } else if (width > 200.0) {
        number = "%.0f";
    } else if (width > 30.0) {
        number = "%.1f";
    } else if (width > 0.9) {
        number = "%.2f";
    }
    const std::string unit = pretty_unit(field.unit);
    const bool tight = unit == "°" || unit == "×";
    return unit.empty() ? number : number + (tight ? "" : " ") + unit;
}

// Returns the width, in pixels, of the widest text of the control.
float text_width(const SettingField& field, const SettingRef& ref, const SettingRef& standard) {
    float width = 0.0F;
    for (const std::string& choice : field.choice_labels)
        width = std::max(width, choice_width(choice));
    if (const auto* const* number = std::get_if<double*>(&ref)) {
        const SliderRange range = slider_range(field, **std::get_if<double*>(&standard), **number);
        const std::string most = fmt::sprintf(number_pattern(range, field), range.high);
        width = ImGui::CalcTextSize(most.c_str()).x + 2.0F * ImGui::GetStyle().FramePadding.x;
    }
    return width;
}

// Returns the width, in pixels, of the control in a row. A wide text may take what a short label
// leaves.
float control_width(const std::string& name, float full, float text, float least) {
    const float usual = std::min((1.0F - kLabelShare) * full, std::max(px(least), 0.35F * full));
    const float label = ImGui::CalcTextSize(name.c_str()).x + px(kLabelMargin);
    return std::max(usual, std::min(text, full - label));
}

template <class Number>
bool number_slider(const SettingField& field, Number& value, double standard, float width) {
    const SliderRange range = slider_range(field, standard, static_cast<double>(value));
    const bool edited = value_slider(value, {.range = range,
                                             .logarithmic = field.logarithmic,
                                             .pattern = number_pattern(range, field),
                                             .width = width,
                                             .allowed = SliderRange{field.low, field.high}});
    if (edited) {
        value = static_cast<Number>(std::clamp(static_cast<double>(value), field.low, field.high));
    }
    return edited;
}

bool whole_number_box(std::uint64_t& value, const SettingField& field, float width) {
    ImGui::SetNextItemWidth(width);
    std::array<char, 32> text{};
    std::to_string(value).copy(text.data(), text.size() - 1);
    if (!ImGui::InputText("##value", text.data(), text.size(),
                          ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll))
        return false;
    const auto typed = parsed_number<std::uint64_t>(text.data());
    if (!typed || static_cast<double>(*typed) > field.high) {
        ui().complaint =
            fmt::format("“{}” is not a whole number from 0 to {:.0f}. The value stays as it was.",
                        text.data(), field.high);
        return false;
    }
    value = *typed;
    return true;
}

bool choice_box(const SettingField& field, std::string& value, float width) {
    bool edited = false;
    if (begin_choice("##value", choice_text(field, value), width)) {
        for (const std::string& choice : field.choices) {
            if (choice_line(choice_text(field, choice), choice == value)) {
                edited = choice != value;
                value = choice;
            }
            note_place(fmt::format("{}={}", path_of(field), choice));
        }
        ImGui::EndCombo();
    }
    return edited;
}

// Draws the control and sets `edited`. Returns whether the change is complete at once, with no
// release to wait for.
bool draw_control(const SettingField& field, const SettingRef& ref, const SettingRef& standard,
                  float width, bool& edited) {
    if (auto* const* flag = std::get_if<bool*>(&ref)) {
        edited = toggle_switch("##" + field.key, **flag);
        return true;
    }
    if (auto* const* text = std::get_if<std::string*>(&ref)) {
        edited = choice_box(field, **text, width);
        return true;
    }
    if (auto* const* seed = std::get_if<std::uint64_t*>(&ref)) {
        edited = whole_number_box(**seed, field, width);
        return true;
    }
    if (auto* const* whole = std::get_if<int*>(&ref)) {
        const double usual = **std::get_if<int*>(&standard);
        edited = number_slider(field, **whole, usual, width);
        return false;
    }
    auto* number = *std::get_if<double*>(&ref);
    edited = number_slider(field, *number, **std::get_if<double*>(&standard), width);
    return false;
}

}  // namespace

void row_label(const std::string& label, bool changed, float width) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float height = ImGui::GetFrameHeight();
    ImGui::Dummy({width, height});
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (changed) {
        list.AddCircleFilled({at.x + px(3), at.y + 0.5F * height}, px(3), paint(colors().accent));
    }
    const std::string shown = fit_text(label, width - px(kLabelMargin));
    const std::string word = shown.substr(0, shown.find(" ("));
    const ImVec2 text = {at.x + px(12), std::floor(at.y + 0.5F * (height - ImGui::GetFontSize()))};
    list.AddText(text, paint(changed ? colors().text : mix(colors().muted, colors().text, 0.35F)),
                 word.c_str());
    list.AddText({text.x + ImGui::CalcTextSize(word.c_str()).x, text.y}, paint(colors().muted),
                 shown.c_str() + word.size());
}

SliderRange slider_range(const SettingField& field, double standard, double present) {
    if (field.logarithmic) return {field.low, field.high};
    constexpr double comfort = 4.0;           // upper end of a slider, in multiples of the default
    constexpr double comfort_from_zero = 10;  // upper end of a slider whose default is 0
    double high = standard == 0.0 ? comfort_from_zero : comfort * std::fabs(standard);
    // A slider covers the full range if that is not much wider.
    if (field.high <= 2.5 * high) high = field.high;
    high = std::max({std::min(high, field.high), present, field.low});
    double low = field.low;
    if (low < -2.5 * high) low = std::min(-high, present);
    return {low, high > low ? high : low + 1.0};
}

RowEvent setting_row(const SettingField& field, ExperimentSettings& settings,
                     ExperimentSettings& defaults, bool in_plain_words) {
    const std::string name = path_of(field);
    const std::string label = in_plain_words ? plain_label(field) : field.label;
    ImGui::PushID(name.c_str());
    const float full = ImGui::GetContentRegionAvail().x;
    const float text = text_width(field, field.at(settings), field.at(defaults));
    const float label_width = std::floor(
        full - control_width(label, full, text, in_plain_words ? kPlainControl : kLeastControl));
    const bool changed = !same_value(field, settings, defaults);
    row_label(label, changed, label_width);
    const bool label_clicked = ImGui::IsItemClicked(ImGuiMouseButton_Right);
    tooltip(help_text(field, defaults));
    ImGui::SameLine(0.0F, 0.0F);
    bool edited = false;
    const bool at_once =
        draw_control(field, field.at(settings), field.at(defaults), full - label_width, edited);
    note_place(name);
    RowEvent event = edited ? at_once ? RowEvent::kFinished : RowEvent::kEdited : RowEvent::kNone;
    if (!at_once && ImGui::IsItemDeactivatedAfterEdit()) event = RowEvent::kFinished;
    tooltip(help_text(field, defaults));
    if (label_clicked || ImGui::IsItemClicked(ImGuiMouseButton_Right)) ImGui::OpenPopup("reset");
    if (ImGui::BeginPopup("reset")) {
        const std::string reset = "Reset to " + value_text(field, field.at(defaults));
        if (ImGui::MenuItem(reset.c_str(), nullptr, false, changed)) {
            copy_value(field, defaults, settings);
            event = RowEvent::kFinished;
        }
        note_place("reset " + name);
        ImGui::EndPopup();
    }
    ImGui::PopID();
    return event;
}

}  // namespace cambrian
