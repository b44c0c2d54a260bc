#include "studio/panels/comparison/comparison_table.h"

#include "core/text/pretty_text.h"
#include "pictures/curves_picture.h"
#include "studio/widgets/widgets.h"

#include <fmt/core.h>

#include <array>

namespace cambrian {
namespace {

struct ArmColumn {
    const char* title;
    const char* help;
    float width;  // in units of 1/96 inch; 0 takes the remaining width
    std::string (*text)(const ComparedArm& arm, const std::string& unit);
};

const std::array kArmColumns = {
    ArmColumn{"Arm", "What differs; the first is the reference", 0,
              [](const ComparedArm& arm, const std::string&) { return arm.name; }},
    ArmColumn{
        "Runs", "Runs that are finished", 60,
        [](const ComparedArm& arm, const std::string&) { return fmt::format("{}", arm.finished); }},
    ArmColumn{"Median",
              "Median of the champions' confirmed scores: each in ten worlds a little "
              "different",
              120,
              [](const ComparedArm& arm, const std::string& unit) {
                  return arm.result ? with_unit(arm.result->median, unit) : std::string();
              }},
    ArmColumn{"90 % interval", "Where the median lies with 90 % confidence (bootstrap)", 136,
              [](const ComparedArm& arm, const std::string&) {
                  return arm.result
                             ? fmt::format("{} to {}", pretty_number(arm.result->interval.low),
                                           pretty_number(arm.result->interval.high))
                             : std::string();
              }},
    ArmColumn{"Ratio", "The median against that of the first arm", 70,
              [](const ComparedArm& arm, const std::string&) {
                  const bool any = arm.result && arm.result->contest && arm.result->contest->ratio;
                  return any ? with_unit(*arm.result->contest->ratio, "x") : std::string();
              }},
    ArmColumn{
        "Senses",
        "Champions that need their senses: they lose more than a tenth of their score if each "
        "sense reads its best constant",
        70,
        [](const ComparedArm& arm, const std::string&) {
            return arm.result ? fmt::format("{} of {}", arm.result->needing, arm.finished)
                              : std::string();
        }},
    ArmColumn{"p", "The probability that chance alone makes the two differ so much (Mann-Whitney)",
              92,
              [](const ComparedArm& arm, const std::string&) {
                  const bool any = arm.result && arm.result->contest;
                  return any ? pretty_number(arm.result->contest->p) : std::string();
              }},
};

void draw_arm(const ComparedArm& arm, std::size_t index, const std::string& unit, Requests& out) {
    ImGui::TableNextRow();
    for (const ArmColumn& column : kArmColumns) {
        ImGui::TableNextColumn();
        std::string text = column.text(arm, unit);
        ImGui::AlignTextToFramePadding();
        if (&column == kArmColumns.data()) {
            const ImVec2 at = ImGui::GetCursorScreenPos();
            const float middle = at.y + 0.5F * ImGui::GetFrameHeight();
            ImGui::GetWindowDrawList()->AddRectFilled({at.x, middle - px(2)},
                                                      {at.x + px(16), middle + px(2)},
                                                      paint(color_of_curve(index)), px(2));
            ImGui::SetCursorPosX(ImGui::GetCursorPosX() + px(24));
            text = fit_text(text, ImGui::GetContentRegionAvail().x);
        }
        ImGui::TextUnformatted(text.c_str());
    }
    note_place("arm " + arm.name);
    ImGui::TableNextColumn();
    ImGui::PushID(static_cast<int>(index));
    if (push_button("Show best", {.look = ButtonLook::kGhost,
                                  .enabled = !arm.champion.empty(),
                                  .tooltip = "Shows the best champion of this arm's runs"})) {
        out.ask(LoadFile{arm.champion});
        out.ask(ToggleComparison{});
    }
    ImGui::PopID();
}

}  // namespace

void draw_comparison_table(const ComparisonResults& results, const std::string& unit,
                           Requests& out) {
    constexpr ImGuiTableFlags flags = ImGuiTableFlags_BordersInnerH;
    if (!ImGui::BeginTable("arms", static_cast<int>(kArmColumns.size()) + 1, flags)) return;
    for (const ArmColumn& column : kArmColumns)
        set_up_column(column.title, column.width);
    set_up_column("", 96);
    ImGui::TableNextRow();
    {
        const WithFont font(ui().fonts.small);
        const WithTextColor color(colors().muted);
        for (const ArmColumn& column : kArmColumns) {
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(column.title);
            tooltip(column.help);
        }
    }
    for (std::size_t i = 0; i < results.arms.size(); ++i)
        draw_arm(results.arms[i], i, unit, out);
    ImGui::EndTable();
}

}  // namespace cambrian
