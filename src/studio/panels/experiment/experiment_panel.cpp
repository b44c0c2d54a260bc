#include "studio/panels/experiment/experiment_panel.h"

#include "core/text/pretty_text.h"
#include "evolution/fields/setting_words.h"
#include "studio/experiment/goal_choice.h"
#include "studio/experiment/setting_groups.h"
#include "studio/frame/ask_preset.h"
#include "studio/frame/change_view.h"
#include "studio/frame/help_mark.h"
#include "studio/panels/experiment/setting_row.h"
#include "studio/panels/experiment/switch_group.h"
#include "studio/widgets/keyboard_focus.h"
#include "studio/widgets/widgets.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>
#include <utility>

namespace cambrian {
namespace {

constexpr float kLabelIndent = 12.0F;    // indentation of the rows' names
constexpr float kRoomForHints = 260.0F;  // the least height in which plain settings have hints

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
        if (preset->of_plane && frame.in_space()) continue;
        if (choice_line(preset->label, preset == shown)) ask_preset(*preset, frame, out);
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
            groups.push_back({table, group_title(table)});
            group = groups.end() - 1;
        }
        if (!same_value(field, draft, defaults)) ++group->changed;
    }
    std::stable_sort(groups.begin(), groups.end(), [](const Group& a, const Group& b) {
        return group_rank(a.table) < group_rank(b.table);
    });
    return groups;
}

void ExperimentPanel::draw(const FrameContext& frame, Requests& out) {
    place_title("Experiment", "experiment", out);
    draw_extent(frame, out);
    draw_filter(frame);
    draw_run_warning(frame, out);
    ExperimentSettings draft = frame.experiment.editor.draft();
    ExperimentSettings defaults = plain_defaults(frame.kinds);
    ImGui::BeginChild("settings", {0, 0}, false, ImGuiWindowFlags_NoBackground);
    const std::vector<Group> groups = list_groups(frame, draft, defaults);
    if (show_seen_ != frame.experiment.show_asked) seek(frame);
    const SettingFilter filter(filter_.data());
    if (!filter.empty()) {
        draw_found(groups, filter, frame, out);
    } else if (!frame.view.all_settings) {
        draw_plain(frame, out);
    } else {
        for (const Group& group : groups)
            draw_group(group, frame, out);
    }
    ImGui::EndChild();
}

// Draws the choice between the plain settings and all.
void ExperimentPanel::draw_extent(const FrameContext& frame, Requests& out) {
    const std::vector<std::string> labels = {"Plain", "All settings"};
    const float width = ImGui::CalcTextSize((labels[0] + labels[1]).c_str()).x + px(36);
    const float left = ImGui::GetWindowContentRegionMax().x - px(kHelpMarkRoom) - width;
    const float title_end = ImGui::GetItemRectMax().x - ImGui::GetWindowPos().x;
    if (left > title_end + px(8)) ImGui::SameLine(left);
    const int chosen = frame.view.all_settings ? 1 : 0;
    const int pressed = segmented("extent", labels, chosen,
                                  {"What matters most, in plain words", "Every setting, by group"});
    if (pressed >= 0 && pressed != chosen)
        change_view(frame, out, [pressed](ViewState& view) { view.all_settings = pressed == 1; });
    ImGui::SetCursorPosY(ImGui::GetCursorPosY() + px(4));
}

// Makes room for a setting that was asked for, and scrolls to it.
void ExperimentPanel::seek(const FrameContext& frame) {
    show_seen_ = frame.experiment.show_asked;
    sought_ = frame.experiment.shown;
    filter_.fill('\0');
    for (const SettingField& field : frame.experiment.fields) {
        if (path_of(field) != sought_) continue;
        open_[shown_table(field)] = true;
        if (!field.group.empty()) open_[shown_table(field) + "/" + field.group] = true;
    }
}

// Draws the choice between two and three dimensions as a row. Either has its own run.
void ExperimentPanel::draw_dimensions(const FrameContext& frame, Requests& out) {
    row_label("Space (dimensions)", false,
              std::floor(ImGui::GetContentRegionAvail().x - px(kPlainControl)));
    ImGui::SameLine(0.0F, 0.0F);
    const int chosen = frame.in_space() ? 1 : 0;
    const int pressed = segmented("dimensions", {"Two", "Three"}, chosen,
                                  {"Bodies in a vertical plane", "Bodies of boxes in space"});
    if (pressed >= 0 && pressed != chosen) out.ask(BeginElsewhere{});
}

// Draws the choice of a world as a row.
void ExperimentPanel::draw_world(const FrameContext& frame, Requests& out) {
    draw_dimensions(frame, out);
    const std::string table = "environment";
    float control = px(kPlainControl);
    for (const SettingPreset& preset : setting_presets(table))
        control = std::max(control, choice_width(preset.label));
    row_label(fmt::format("{} ({})", setting_words(table)->word, table), false,
              std::floor(ImGui::GetContentRegionAvail().x - control));
    ImGui::SameLine(0.0F, 0.0F);
    draw_presets(table, frame, out);
}

// Draws the settings that matter most, each with what it does where there is room.
void ExperimentPanel::draw_plain(const FrameContext& frame, Requests& out) {
    const bool roomy = ImGui::GetWindowHeight() > px(kRoomForHints);
    for (const std::string_view path : kPlainSettings) {
        const auto& fields = frame.experiment.fields;
        const auto field = std::find_if(fields.begin(), fields.end(),
                                        [path](const auto& each) { return path_of(each) == path; });
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(px(8), px(roomy ? 3 : 8)));
        if (field == fields.end()) {
            draw_world(frame, out);
        } else {
            draw_row(*field, frame, out);
        }
        if (path == "goal.behavior") {
            draw_goal_help(frame);
        } else if (roomy) {
            ImGui::Indent(px(kLabelIndent));
            muted_text(std::string(setting_words(path)->hint));
            ImGui::Unindent(px(kLabelIndent));
        }
        ImGui::PopStyleVar();
        if (roomy) ImGui::Dummy({0, px(3)});
    }
    draw_other_changes(frame, out);
}

// Tells which settings differ from their defaults without being among the plain ones.
void ExperimentPanel::draw_other_changes(const FrameContext& frame, Requests& out) {
    ExperimentSettings draft = frame.experiment.editor.draft();
    ExperimentSettings defaults = plain_defaults(frame.kinds);
    std::string names;
    int count = 0;
    for (const SettingField& field : frame.experiment.fields) {
        const bool applies = !field.applies || field.applies(draft);
        if (is_plain(path_of(field)) || !applies || same_value(field, draft, defaults)) continue;
        names += (names.empty() ? "" : ", ") + field.label;
        ++count;
    }
    if (count == 0) return;
    const std::string words =
        fmt::format("{} more {} from {} default", count, count == 1 ? "differs" : "differ",
                    count == 1 ? "its" : "their");
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::GetWindowDrawList()->AddCircleFilled({at.x + px(3), at.y + px(15)}, px(3),
                                                paint(colors().accent));
    ImGui::Indent(px(kLabelIndent));
    if (push_button(words, {.look = ButtonLook::kGhost, .tooltip = names.c_str()}))
        change_view(frame, out, [](ViewState& view) { view.all_settings = true; });
    ImGui::Unindent(px(kLabelIndent));
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
    bool& open = open_.try_emplace(group.table, is_open_at_first(group.table)).first->second;
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
    if (group.table == "environment") draw_dimensions(frame, out);
    draw_presets(group.table, frame, out);
    for (const SettingField& field : frame.experiment.fields) {
        if (shown_table(field) != group.table || !field.group.empty()) continue;
        if (path_of(field) == "environment.dimensions") continue;  // drawn above
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

// Scrolls to the row about to be drawn if it is sought, and marks it for a while.
void ExperimentPanel::light_up(const std::string& path) {
    constexpr double while_lit = 2.5;  // s
    if (path == sought_) {
        ImGui::SetScrollHereY(0.3F);
        ImGui::SetKeyboardFocusHere();
        lit_ = std::exchange(sought_, {});
        lit_until_ = ImGui::GetTime() + while_lit;
    }
    if (path != lit_ || ImGui::GetTime() > lit_until_) return;
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    ImGui::GetWindowDrawList()->AddRectFilled(
        {low.x, low.y - px(2)}, {low.x + width, low.y + ImGui::GetFrameHeight() + px(2)},
        paint(with_alpha(colors().accent, 0.3F)), px(5));
    note_place("## lit setting", {low.x, low.y, width, ImGui::GetFrameHeight()});
}

void ExperimentPanel::draw_row(const SettingField& field, const FrameContext& frame,
                               Requests& out) {
    ExperimentSettings defaults = plain_defaults(frame.kinds);
    ExperimentSettings edited = frame.experiment.editor.draft();
    light_up(path_of(field));
    const RowEvent event =
        setting_row(field, edited, defaults, !frame.view.all_settings && is_plain(path_of(field)));
    if (event == RowEvent::kNone) return;
    if (field.table == "goal") adopt_goal(edited, frame);
    if (frame.kinds.breeding.find(field.key) != nullptr)
        balance_shares(frame.experiment.fields, field.key, edited);
    out.ask(EditSettings{std::move(edited), path_of(field)});
    if (event == RowEvent::kFinished) out.ask(FinishEdit{});
}

}  // namespace cambrian
