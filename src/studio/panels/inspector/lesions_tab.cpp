#include "studio/panels/inspector/lesions_tab.h"

#include "core/text/counted.h"
#include "core/text/pretty_text.h"
#include "studio/widgets/widgets.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace cambrian {
namespace {

constexpr float kLesionRowHeight = 34.0F;
constexpr std::size_t kMostPlaces = 3;  // rows whose place is noted

// The unit of the displayed creature's score.
std::string unit_of_lesions(const FrameContext& frame) {
    return goal_unit(frame.viewer.playback.exhibit().settings().goal, frame.kinds.goals);
}

double share_of_intact(double score, const LesionTable& table) {
    return table.intact.left > 0.0 ? score / table.intact.left : 1.0;
}

// From grey, where nothing is lost, to red, where all is.
Color loss_color(double left) {
    const auto lost = static_cast<float>(std::clamp(1.0 - left, 0.0, 1.0));
    return mix(colors().muted, colors().danger, std::sqrt(lost));
}

std::string row_tooltip(const LesionRow& row, const std::string& words, const std::string& unit) {
    const auto [least, most] = std::minmax_element(row.scores.begin(), row.scores.end());
    return fmt::format("{}\n{} {} is left: the median of {}, {} to {}", words,
                       pretty_number(row.left), unit, counted(row.scores.size(), "world"),
                       pretty_number(*least), pretty_number(*most));
}

// A bar as long as the share that is left, and a line over the range in all worlds.
void draw_share(ImDrawList& list, const Rect& area, const LesionRow& row,
                const LesionTable& table) {
    const auto at = [&](double score) {
        return area.x +
               area.width *
                   static_cast<float>(std::clamp(share_of_intact(score, table), 0.0, 1.25) / 1.25);
    };
    const Color color = loss_color(share_of_intact(row.left, table));
    list.AddRectFilled(area.low(), area.high(), paint(mix(colors().panel, colors().raised, 0.6F)),
                       px(2));
    list.AddRectFilled(area.low(), {std::max(at(row.left), area.x + px(2)), area.y + area.height},
                       paint(color), px(2));
    const auto [least, most] = std::minmax_element(row.scores.begin(), row.scores.end());
    const float middle = area.y + 0.5F * area.height;
    list.AddLine({at(*least), middle}, {at(*most), middle}, paint(colors().text), px(1));
    list.AddLine({at(table.intact.left), area.y}, {at(table.intact.left), area.y + area.height},
                 paint(colors().faint), px(1));
}

const LesionTable* table_of_shown(const FrameContext& frame) {
    const LesionLab* lab = frame.viewer.lesions;
    return lab == nullptr ? nullptr : lab->table_of(frame.viewer.playback.exhibit().genome());
}

// Rows of a table, and what their places are called.
struct LesionList {
    const LesionTable& table;
    const std::vector<LesionRow>& rows;
    const char* kind;
};

void draw_lesion_row(const LesionList& list, std::size_t index, const FrameContext& frame,
                     Requests& out) {
    const LesionRow& row = list.rows[index];
    const PlayedCreature& creature = frame.viewer.playback.creature();
    const std::string words =
        capitalized(words_of(row.lesions, creature.whole(), frame.kinds.creature));
    const std::string name = fmt::format("{} {}", list.kind, index);
    const float width = ImGui::GetContentRegionAvail().x;
    const bool chosen = creature.lesions() == row.lesions;
    if (ImGui::InvisibleButton(name.c_str(), {width, px(kLesionRowHeight)}))
        out.ask(InflictLesions{chosen ? std::vector<Lesion>() : row.lesions});
    if (index < kMostPlaces) note_place(name);
    const bool hovered = ImGui::IsItemHovered();
    const int part = part_of(row.lesions.front(), creature.whole());
    if (hovered && part >= 0 && creature.lesions().empty()) out.ask(ShowHighlight{{.part = part}});
    tooltip(row_tooltip(row, words, unit_of_lesions(frame)));
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    ImDrawList& drawn = *ImGui::GetWindowDrawList();
    if (hovered || chosen)
        drawn.AddRectFilled(low, high, paint(chosen ? colors().raised : colors().hovered), px(4));
    const WithFont font(ui().fonts.small);
    const std::string share =
        fmt::format("{:.0f} %", 100.0 * std::max(0.0, share_of_intact(row.left, list.table)));
    const float share_width = ImGui::CalcTextSize(share.c_str()).x;
    const float right = high.x - px(6);
    drawn.AddText({low.x + px(6), low.y + px(3)}, paint(colors().text),
                  fit_text(words, right - low.x - share_width - px(16)).c_str());
    drawn.AddText({right - share_width, low.y + px(3)},
                  paint(loss_color(share_of_intact(row.left, list.table))), share.c_str());
    draw_share(drawn, {low.x + px(6), high.y - px(10), right - low.x - px(6), px(5)}, row,
               list.table);
}

void draw_rows(const LesionList& list, const FrameContext& frame, Requests& out) {
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(list.rows.size()), px(kLesionRowHeight + 2));
    while (clipper.Step()) {
        for (int row = clipper.DisplayStart; row < clipper.DisplayEnd; ++row)
            draw_lesion_row(list, static_cast<std::size_t>(row), frame, out);
    }
}

}  // namespace

void LesionsTab::draw(const FrameContext& frame, Requests& out) {
    muted_text(
        "What is left of the score when one thing is taken away, in 11 slightly different worlds.");
    draw_controls(frame, out);
    if (const LesionTable* table = table_of_shown(frame)) draw_table(*table, frame, out);
}

void LesionsTab::draw_controls(const FrameContext& frame, Requests& out) {
    const LesionLab* lab = frame.viewer.lesions;
    if (lab == nullptr) return;
    if (lab->running()) {
        if (push_button("Stop study", {.height = px(26)})) out.ask(StopLesions{});
        ImGui::SameLine();
        ImGui::AlignTextToFramePadding();
        muted_text(lab->pruning() ? "Pruning…" : "Taking things away…");
        progress_bar(static_cast<float>(lab->share()), 0.0F, px(6));
        return;
    }
    if (push_button("Find lesions", {.look = ButtonLook::kPrimary,
                                     .height = px(26),
                                     .tooltip = "Takes each part, joint, neuron, link, sensor and "
                                                "organ away in turn, in the background."}))
        out.ask(StudyLesions{});
    ImGui::SameLine();
    if (push_button("Pairs", {.height = px(26),
                              .tooltip = "The same, and the ten worst lesions two at a time: what "
                                         "stands in for something else shows only so."}))
        out.ask(StudyLesions{.pairs = true});
    ImGui::SameLine();
    if (push_button("Prune", {.height = px(26),
                              .tooltip = "Removes all genes that cost nothing, and displays what "
                                         "is left. Ctrl+Z takes it back, Ctrl+S saves it."}))
        out.ask(PruneShown{});
}

void LesionsTab::draw_table(const LesionTable& table, const FrameContext& frame, Requests& out) {
    fact("Intact", pretty_number(table.intact.left) + " " + unit_of_lesions(frame));
    muted_text("A click plays the creature so; another one makes it whole again.");
    ImGui::BeginChild("lesions", {0, 0}, false, ImGuiWindowFlags_NoBackground);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(px(8), px(2)));
    draw_rows({table, table.pairs, "pair"}, frame, out);
    if (!table.pairs.empty()) caption("One at a time:");
    draw_rows({table, table.rows, "lesion"}, frame, out);
    ImGui::PopStyleVar();
    ImGui::EndChild();
}

}  // namespace cambrian
