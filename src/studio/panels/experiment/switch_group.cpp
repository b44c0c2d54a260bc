#include "studio/panels/experiment/switch_group.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace cambrian {
namespace {

bool& switch_of(const SettingField& field, ExperimentSettings& settings) {
    return *std::get<bool*>(field.at(settings));
}

std::size_t count_on(const SwitchGroup& group, ExperimentSettings& settings) {
    return static_cast<std::size_t>(
        std::count_if(group.switches.begin(), group.switches.end(),
                      [&](const SettingField* field) { return switch_of(*field, settings); }));
}

}  // namespace

std::vector<SwitchGroup> switch_groups(std::span<const SettingField> fields,
                                       const std::string& table) {
    std::vector<SwitchGroup> groups;
    for (const SettingField& field : fields) {
        if (field.table != table || field.group.empty()) continue;
        auto group = std::find_if(groups.begin(), groups.end(), [&](const SwitchGroup& each) {
            return each.label == field.group;
        });
        if (group == groups.end()) {
            groups.push_back({field.group, {}});
            group = groups.end() - 1;
        }
        group->switches.push_back(&field);
    }
    return groups;
}

Tick tick_of(const SwitchGroup& group, ExperimentSettings& settings) {
    const std::size_t on = count_on(group, settings);
    if (on == 0) return Tick::kOff;
    return on == group.switches.size() ? Tick::kOn : Tick::kSome;
}

void set_all(const SwitchGroup& group, bool on, ExperimentSettings& settings) {
    for (const SettingField* field : group.switches)
        switch_of(*field, settings) = on;
}

bool switch_group_row(const SwitchGroup& group, ExperimentSettings& settings, bool& open) {
    ImGui::PushID(group.label.c_str());
    ImGui::Dummy({px(10), px(18)});
    ImGui::SameLine(0.0F, 0.0F);
    const bool ticked = tick_box("tick " + group.label, tick_of(group, settings));
    tooltip("All of them on or off.");
    ImGui::SameLine(0.0F, px(8));
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const ImVec2 size = {ImGui::GetContentRegionAvail().x, px(18)};
    if (ImGui::InvisibleButton("name", size)) open = !open;
    note_place("senses " + group.label);
    const bool hovered = ImGui::IsItemHovered();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float text_y = std::floor(at.y + 0.5F * (size.y - ImGui::GetFontSize()));
    list.AddText({at.x, text_y}, paint(hovered ? colors().accent : colors().text),
                 group.label.c_str());
    const std::string count =
        fmt::format("{} of {}", count_on(group, settings), group.switches.size());
    const float right = at.x + size.x - px(22);
    list.AddText({right - ImGui::CalcTextSize(count.c_str()).x, text_y}, paint(colors().muted),
                 count.c_str());
    draw_icon(list, open ? Icon::kChevronDown : Icon::kChevronRight,
              {at.x + size.x - px(9), at.y + 0.5F * size.y}, px(9), colors().muted);
    ImGui::PopID();
    return ticked;
}

}  // namespace cambrian
