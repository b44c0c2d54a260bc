#include "studio/panels/experiment/experiment_panel.h"

#include "core/text/pretty_text.h"
#include "studio/experiment/goal_choice.h"
#include "studio/experiment/setting_presets.h"
#include "studio/frame/help_mark.h"
#include "studio/panels/experiment/setting_row.h"
#include "studio/panels/experiment/switch_group.h"
#include "studio/widgets/keyboard_focus.h"
#include "studio/widgets/widgets.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string_view>
#include <utility>

namespace cambrian {
namespace {

constexpr float kLabelIndent = 12.0F;  // indentation of the rows' names

struct GroupName {
    std::string_view table;
    std::string_view title;
    bool open;  // whether the group is open at first
};

// The groups in the order shown. Tables that are not listed follow under their own name.
constexpr std::array kGroups = {
    GroupName{"goal", "Goal", true},
    GroupName{"environment", "Environment", true},
    GroupName{"population", "Population", true},
    GroupName{"selection", "Selection", true},
    GroupName{"breeding", "Breeding", false},
    GroupName{"mutation", "Mutation", true},
    GroupName{"mutation.weights", "Mutation weights", false},
    GroupName{"body", "Body and brain", false},
    GroupName{"body.joints", "Joints allowed", false},
    GroupName{"body.functions", "Neurons allowed", false},
    GroupName{"body.sensors", "Senses", false},
    GroupName{"body.organs", "Organs allowed", false},
    GroupName{"body.references", "Links allowed", false},
    GroupName{"simulation", "Physics", false},
    GroupName{"trial", "Trial", false},
    GroupName{"run", "Run", false},
};

const GroupName* named(std::string_view table) {
    const auto found = std::find_if(kGroups.begin(), kGroups.end(),
                                    [table](const GroupName& each) { return each.table == table; });
    return found == kGroups.end() ? nullptr : &*found;
}

std::size_t rank_of(std::string_view table) {
    const GroupName* group = named(table);
    return group == nullptr ? kGroups.size() : static_cast<std::size_t>(group - kGroups.data());
}

// Returns the table whose group shows a setting: its own, except for senses that a world takes
// away.
std::string shown_table(const SettingField& field) {
    constexpr std::array<std::string_view, 2> senses = {"deafness", "anosmia"};
    const bool sense = field.table == "environment" &&
                       std::find(senses.begin(), senses.end(), field.key) != senses.end();
    return sense ? "body.sensors" : field.table;
}

void adopt_goal(ExperimentSettings& edited, const FrameContext& frame) {
    const GoalKind* chosen = frame.kinds.goals.find(edited.goal);
    const GoalKind* before = frame.kinds.goals.find(frame.experiment.editor.draft().goal);
    if (chosen != nullptr && before != nullptr)
        change_goal(edited, *before, *chosen, frame.experiment.fields);
}

// Draws a choice among the table's presets, if it has any.
void draw_presets(const std::string& table, const FrameContext& frame, Requests& out) {
    const auto presets = setting_presets(table);
    if (presets.empty()) return;
    const ExperimentSettings& draft = frame.experiment.editor.draft();
    const auto shown = std::find_if(presets.begin(), presets.end(), [&](const auto& preset) {
        return is_in_force(preset, draft, frame.kinds, frame.experiment.fields);
    });
    const bool open = begin_choice("##preset", shown == presets.end() ? "Custom" : shown->label,
                                   ImGui::GetContentRegionAvail().x);
    if (!open) {
        note_place(table + " preset");
        return;
    }
    for (auto preset = presets.begin(); preset != presets.end(); ++preset) {
        if (ImGui::Selectable(preset->label, preset == shown)) {
            ExperimentSettings edited = draft;
            preset->apply(edited, frame.kinds);
            out.ask(EditSettings{std::move(edited), table});
            out.ask(FinishEdit{});
        }
        note_place(preset->label);
        tooltip(preset->help);
    }
    ImGui::EndCombo();
}

// Describes what the goal rewards, and warns if the environment makes it impossible.
void draw_goal_help(const FrameContext& frame) {
    const ExperimentSettings& draft = frame.experiment.editor.draft();
    const GoalKind* goal = frame.kinds.goals.find(draft.goal);
    if (goal == nullptr) return;
    ImGui::Indent(px(kLabelIndent));
    muted_text(goal->help);
    ImGui::Unindent(px(kLabelIndent));
    const std::string mismatch =
        goal->mismatch == nullptr ? "" : goal->mismatch(draft.world.environment);
    if (mismatch.empty()) return;
    const WithTextColor warning(colors().danger);
    ImGui::TextWrapped("Makes little sense in this world: %s.", mismatch.c_str());
    note_place("goal mismatch");
}

// After an edit of one breeding method's share, scales the shares of the others so that the sum
// stays 1.
void balance_shares(const std::vector<SettingField>& fields, const std::string& edited,
                    ExperimentSettings& settings) {
    for (const SettingField& field : fields) {
        // Accessing a field creates its entry in the map.
        if (field.table == "breeding") static_cast<void>(field.at(settings));
    }
    std::map<std::string, double>& shares = settings.breeding.shares;
    const double left = 1.0 - shares[edited];
    double others = 0.0;
    for (const auto& [way, share] : shares)
        others += way == edited ? 0.0 : share;
    for (auto& [way, share] : shares) {
        if (way == edited) continue;
        share =
            others > 0.0 ? share * left / others : left / static_cast<double>(shares.size() - 1);
    }
}

}  // namespace

std::vector<ExperimentPanel::Group> ExperimentPanel::list_groups(
    const FrameContext& frame, ExperimentSettings& draft, ExperimentSettings& defaults) const {
    std::vector<Group> groups;
    for (const SettingField& field : frame.experiment.fields) {
        auto group = std::find_if(groups.begin(), groups.end(), [&field](const Group& each) {
            return each.table == shown_table(field);
        });
        if (group == groups.end()) {
            const std::string table = shown_table(field);
            const GroupName* name = named(table);
            groups.push_back(
                {table, name != nullptr ? std::string(name->title) : capitalized(table)});
            group = groups.end() - 1;
        }
        if (!same_value(field, draft, defaults)) ++group->changed;
    }
    std::stable_sort(groups.begin(), groups.end(), [](const Group& a, const Group& b) {
        return rank_of(a.table) < rank_of(b.table);
    });
    return groups;
}

void ExperimentPanel::draw(const FrameContext& frame, Requests& out) {
    place_title("Experiment", "experiment", out);
    draw_filter(frame);
    draw_run_warning(frame, out);
    ExperimentSettings draft = frame.experiment.editor.draft();
    ExperimentSettings defaults;
    ImGui::BeginChild("settings", {0, 0}, false, ImGuiWindowFlags_NoBackground);
    const std::vector<Group> groups = list_groups(frame, draft, defaults);
    const SettingFilter filter(filter_.data());
    if (!filter.empty()) {
        draw_found(groups, filter, frame, out);
    } else {
        for (const Group& group : groups)
            draw_group(group, frame, out);
    }
    ImGui::EndChild();
}

void ExperimentPanel::draw_filter(const FrameContext& frame) {
    if (find_seen_ != frame.experiment.find_asked) ImGui::SetKeyboardFocusHere();
    find_seen_ = frame.experiment.find_asked;
    const bool any = filter_[0] != '\0';
    const float clear_width = any ? px(30) + px(4) : 0.0F;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - clear_width);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(px(30), px(5)));
    first_wanted_ = ImGui::InputTextWithHint("##filter", "Find a setting", filter_.data(),
                                             filter_.size(), ImGuiInputTextFlags_EnterReturnsTrue);
    ImGui::PopStyleVar();
    const int escape = ImGui::GetKeyIndex(ImGuiKey_Escape);
    const bool escaped = escape >= 0 && ImGui::IsKeyPressed(escape) &&
                         (ImGui::IsItemDeactivated() || ImGui::IsItemActive());
    note_place("setting filter");
    focus_stop_for_text();
    // A tooltip would cover what is found.
    if (!any)
        tooltip(
            "Words of a setting's name or of what it does (/ or Ctrl+F). Enter goes to the first "
            "one found, Esc clears.");
    draw_icon(*ImGui::GetWindowDrawList(), Icon::kSearch,
              {at.x + px(15), at.y + 0.5F * ImGui::GetItemRectSize().y}, px(13), colors().muted);
    if (any) ImGui::SameLine(0, px(4));
    const bool cleared =
        any && push_button("Clear filter", {.look = ButtonLook::kGhost,
                                            .icon = Icon::kClose,
                                            .label_shown = false,
                                            .width = px(30),
                                            .height = ImGui::GetFrameHeight(),
                                            .tooltip = "Show all settings again (Esc)"});
    if (escaped || cleared) filter_.fill('\0');
}

// Draws the settings that the filter found, under the titles of their groups.
void ExperimentPanel::draw_found(const std::vector<Group>& groups, const SettingFilter& filter,
                                 const FrameContext& frame, Requests& out) {
    bool any = false;
    for (const Group& group : groups) {
        bool titled = false;
        for (const SettingField& field : frame.experiment.fields) {
            const bool applies = !field.applies || field.applies(frame.experiment.editor.draft());
            if (shown_table(field) != group.table || !applies || !filter.finds(field, group.title))
                continue;
            if (!titled) caption(group.title);
            titled = true;
            if (first_wanted_ && !any) ImGui::SetKeyboardFocusHere();
            any = true;
            draw_row(field, frame, out);
        }
    }
    if (any) return;
    muted_text("No setting matches. Those of methods not chosen are hidden.");
    note_place("nothing matches");
}

void ExperimentPanel::draw_run_warning(const FrameContext& frame, Requests& out) {
    const std::vector<std::string> waiting =
        structural_changes(*frame.experiment.snapshot.settings, frame.experiment.editor.draft(),
                           frame.experiment.fields);
    const bool fresh =
        frame.experiment.snapshot.generation == 0 && frame.experiment.snapshot.population.empty();
    if (waiting.empty() || fresh) return;
    std::string names = waiting.front();
    for (std::size_t i = 1; i < waiting.size(); ++i)
        names += ", " + waiting[i];
    muted_text(
        fmt::format("{} {} effect in a new run.", names, waiting.size() == 1 ? "takes" : "take"));
    if (push_button("New run", {.look = ButtonLook::kPrimary,
                                .tooltip = "From random creatures, with another seed."}))
        out.ask(StartNewRun{false});
    ImGui::SameLine();
    if (push_button("Keep creatures", {.tooltip = "A new run from the present population."}))
        out.ask(StartNewRun{true});
    ImGui::SameLine();
    if (push_button("Undo##run", {.look = ButtonLook::kGhost,
                                  .icon = Icon::kClose,
                                  .label_shown = false,
                                  .tooltip = "Undo these changes and keep the present run."}))
        out.ask(DropStructuralEdits{});
}

bool ExperimentPanel::draw_header(const Group& group) {
    const GroupName* name = named(group.table);
    bool& open = open_.try_emplace(group.table, name != nullptr && name->open).first->second;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const ImVec2 size = {ImGui::GetContentRegionAvail().x, px(32)};
    if (ImGui::InvisibleButton(group.title.c_str(), size)) open = !open;
    note_place("group " + group.table);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const bool hovered = ImGui::IsItemHovered();
    list.AddLine(at, {at.x + size.x, at.y}, paint(colors().border));
    const float middle = at.y + 0.5F * size.y;
    draw_icon(list, open ? Icon::kChevronDown : Icon::kChevronRight, {at.x + px(7), middle}, px(10),
              hovered ? colors().text : colors().muted);
    const WithFont font(ui().fonts.strong);
    const float text_y = std::floor(middle - 0.5F * ImGui::GetFontSize());
    list.AddText({at.x + px(22), text_y}, paint(colors().text), group.title.c_str());
    if (group.changed > 0) {
        const std::string count = std::to_string(group.changed);
        const float width = ImGui::CalcTextSize(count.c_str()).x;
        list.AddText({at.x + size.x - width - px(6), text_y}, paint(colors().accent),
                     count.c_str());
    }
    return open;
}

void ExperimentPanel::draw_group(const Group& group, const FrameContext& frame, Requests& out) {
    if (!draw_header(group)) return;
    ImGui::PushID(group.table.c_str());
    draw_presets(group.table, frame, out);
    for (const SettingField& field : frame.experiment.fields) {
        if (shown_table(field) != group.table || !field.group.empty()) continue;
        if (!field.applies || field.applies(frame.experiment.editor.draft()))
            draw_row(field, frame, out);
    }
    draw_switch_groups(group.table, frame, out);
    if (group.table == "goal") draw_goal_help(frame);
    ImGui::Dummy({0, px(4)});
    ImGui::PopID();
}

void ExperimentPanel::draw_switch_groups(const std::string& table, const FrameContext& frame,
                                         Requests& out) {
    for (const SwitchGroup& group : switch_groups(frame.experiment.fields, table)) {
        ExperimentSettings edited = frame.experiment.editor.draft();
        const std::string name = table + "/" + group.label;
        bool& open = open_[name];
        if (switch_group_row(group, edited, open)) {
            set_all(group, tick_of(group, edited) != Tick::kOn, edited);
            out.ask(EditSettings{std::move(edited), name});
            out.ask(FinishEdit{});
        }
        if (!open) continue;
        for (const SettingField* field : group.switches)
            draw_row(*field, frame, out);
    }
}

void ExperimentPanel::draw_row(const SettingField& field, const FrameContext& frame,
                               Requests& out) {
    ExperimentSettings defaults;
    ExperimentSettings edited = frame.experiment.editor.draft();
    const RowEvent event = setting_row(field, edited, defaults);
    if (event == RowEvent::kNone) return;
    if (field.table == "goal") adopt_goal(edited, frame);
    if (frame.kinds.breeding.find(field.key) != nullptr)
        balance_shares(frame.experiment.fields, field.key, edited);
    out.ask(EditSettings{std::move(edited), path_of(field)});
    if (event == RowEvent::kFinished) out.ask(FinishEdit{});
}

}  // namespace cambrian
