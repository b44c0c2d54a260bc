#include "studio/panels/timeline_panel.h"

#include "studio/help_mark.h"
#include "studio/text.h"
#include "studio/widgets.h"

#include <algorithm>
#include <cmath>

namespace cambrian {
namespace {

constexpr double kNewcomerShare = 0.2;
constexpr const char* kManyKinds = "map-elites";

void legend_entry(const char* name, const Color& color, bool band) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float middle = at.y + 0.5F * ImGui::GetFontSize();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float half = band ? px(5) : px(1.2F);
    list.AddRectFilled({at.x, middle - half}, {at.x + px(14), middle + half}, paint(color), px(1));
    ImGui::Dummy({px(14), ImGui::GetFontSize()});
    ImGui::SameLine(0, px(6));
    const WithTextColor muted(colors().muted);
    ImGui::TextUnformatted(name);
}

void draw_heading(const FrameContext& frame, Requests& out) {
    const GoalKind* goal = frame.kinds.goals.find(frame.snapshot.settings->goal);
    panel_title("Timeline");
    const WithFont font(ui().fonts.small);
    ImGui::SameLine(0, px(10));
    {
        const WithTextColor muted(colors().muted);
        ImGui::TextUnformatted(goal == nullptr ? ""
                                               : ("fitness in " + pretty_unit(goal->unit)).c_str());
    }
    const float right = ImGui::GetWindowContentRegionMax().x;
    ImGui::SameLine(std::max(ImGui::GetCursorPosX() + px(20), right - px(246)));
    legend_entry("best", colors().plot_best, false);
    ImGui::SameLine(0, px(12));
    legend_entry("median", colors().plot_median, false);
    ImGui::SameLine(0, px(12));
    legend_entry("10–90 %", with_alpha(colors().plot_median, 0.3F), true);
    ImGui::SameLine(right - px(24));
    help_mark("timeline", out);
}

// What may help where the best has not risen for long (evolution.md 6.4); nothing is done unasked.
void draw_stagnation(const FrameContext& frame, Requests& out) {
    const auto& history = frame.snapshot.history;
    if (history.empty() || !stagnant(history.back())) return;
    const ExperimentSettings& draft = frame.editor.draft();
    ImGui::AlignTextToFramePadding();
    muted_text(format("The best has not risen for %d generations.",
                      history.back().generations_without_progress));
    ImGui::SameLine(0, px(10));
    if (push_button("Add newcomers",
                    {.tooltip = "Once, a fifth of the next generation is new random creatures."}))
        out.ask(AddNewcomers{kNewcomerShare});
    if (draft.selection.method == kManyKinds) return;
    ImGui::SameLine();
    if (push_button("Many kinds", {.tooltip = "Keep the fittest of every kind of body: the "
                                              "selection method becomes MAP-Elites."})) {
        ExperimentSettings edited = draft;
        edited.selection.method = kManyKinds;
        out.ask(EditSettings{std::move(edited), "selection.method"});
        out.ask(FinishEdit{});
    }
}

// Labels of the settings in which two journal entries differ, one a line.
std::string difference(const FrameContext& frame, const ExperimentSettings& before,
                       const ExperimentSettings& after) {
    ExperimentSettings a = before;
    ExperimentSettings b = after;
    std::string text;
    for (const SettingField& field : frame.fields) {
        if (same_value(field, a, b)) continue;
        text += '\n';
        text += field.label;
        const SettingRef from = field.at(a);
        const SettingRef to = field.at(b);
        if (auto* const* number = std::get_if<double*>(&from)) {
            text += ' ';
            text += pretty_number(**number);
            text += " → ";
            text += with_unit(**std::get_if<double*>(&to), field.unit);
        }
    }
    return text;
}

std::string change_at(const FrameContext& frame, std::uint32_t generation) {
    std::string text;
    const auto& journal = frame.snapshot.journal;
    for (std::size_t i = 1; i < journal.size(); ++i) {
        if (journal[i].generation != generation) continue;
        text += difference(frame, *journal[i - 1].settings, *journal[i].settings);
    }
    if (!text.empty()) text.insert(0, "\n\nChanged here:");
    return text;
}

}  // namespace

void TimelinePanel::gather(const EvolutionSnapshot& snapshot) {
    if (snapshot.experiment != experiment_ || snapshot.history.size() < generations_.size()) {
        for (auto* column : {&generations_, &best_, &upper_, &median_, &lower_})
            column->clear();
        experiment_ = snapshot.experiment;
    }
    for (std::size_t i = generations_.size(); i < snapshot.history.size(); ++i) {
        const GenerationStatistics& row = snapshot.history[i];
        generations_.push_back(row.generation);
        best_.push_back(row.best);
        upper_.push_back(row.upper);
        median_.push_back(row.median);
        lower_.push_back(row.lower);
    }
}

PlotScale TimelinePanel::scale_for(const Rect& area) const {
    const double lowest = *std::min_element(lower_.begin(), lower_.end());
    const double highest = *std::max_element(best_.begin(), best_.end());
    const Range y = plot_range(std::min(0.0, lowest), highest);
    const double last = std::max(generations_.back(), generations_.front() + 10.0);
    return {area, generations_.front(), last, y.low, y.high};
}

void TimelinePanel::draw(const FrameContext& frame, Requests& out) {
    draw_heading(frame, out);
    draw_stagnation(frame, out);
    gather(frame.snapshot);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const ImVec2 room = ImGui::GetContentRegionAvail();
    if (generations_.empty()) {
        ImGui::Dummy({0, px(6)});
        muted_text("Press Evolve: each finished generation adds a point here.");
        return;
    }
    const Rect area = {at.x + px(46), at.y + px(6), room.x - px(54), room.y - px(26)};
    if (area.height < px(20)) return;
    const PlotScale scale = scale_for(area);
    ImGui::SetCursorScreenPos(area.low());
    ImGui::InvisibleButton("plot", {area.width, area.height});
    note_place("timeline");
    draw_axes(*ImGui::GetWindowDrawList(), scale);
    draw_changes(scale, frame.snapshot);
    draw_curves(scale);
    handle_mouse(scale, frame, out);
}

void TimelinePanel::draw_curves(const PlotScale& scale) const {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    draw_band(list, scale, generations_, lower_, upper_, with_alpha(colors().plot_median, 0.22F));
    draw_curve(list, scale, generations_, median_, colors().plot_median, px(1.5F));
    draw_curve(list, scale, generations_, best_, colors().plot_best, px(2));
}

void TimelinePanel::draw_changes(const PlotScale& scale, const EvolutionSnapshot& snapshot) const {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float top = scale.area.y;
    const float bottom = top + scale.area.height;
    for (std::size_t i = 1; i < snapshot.journal.size(); ++i) {
        const auto generation = static_cast<double>(snapshot.journal[i].generation);
        if (generation > scale.x_high) continue;
        const float x = std::floor(scale.x_at(generation)) + 0.5F;
        list.AddLine({x, top}, {x, bottom}, paint(with_alpha(colors().accent, 0.45F)));
        list.AddTriangleFilled({x - px(5), top - px(5)}, {x + px(5), top - px(5)}, {x, top + px(3)},
                               paint(colors().accent));
    }
}

void TimelinePanel::handle_mouse(const PlotScale& scale, const FrameContext& frame,
                                 Requests& out) const {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const Rect& area = scale.area;
    const auto line_at = [&](double generation, const Color& color) {
        const float x = std::floor(scale.x_at(generation)) + 0.5F;
        list.AddLine({x, area.y}, {x, area.y + area.height}, paint(color));
    };
    if (!frame.playback.empty() && frame.playback.exhibit().source == ExhibitSource::kChampion) {
        line_at(frame.playback.exhibit().generation, with_alpha(colors().text, 0.55F));
    }
    if (!ImGui::IsItemHovered() && !ImGui::IsItemActive()) return;
    const double under = scale.x_from(ImGui::GetIO().MousePos.x) - generations_.front();
    const double last = static_cast<double>(generations_.size() - 1);
    const auto row = static_cast<std::size_t>(std::clamp(std::round(under), 0.0, last));
    line_at(generations_[row], with_alpha(colors().text, 0.3F));
    list.AddCircleFilled({scale.x_at(generations_[row]), scale.y_at(best_[row])}, px(4),
                         paint(colors().plot_best));
    const auto generation = static_cast<std::uint32_t>(generations_[row]);
    const GenerationStatistics& stats = frame.snapshot.history[row];
    if (ImGui::IsItemActive()) {
        out.ask(ShowChampion{generation});
        return;
    }
    const std::string text = format(
        "Generation %u\nBest %s, median %s\n10–90 %%: %s to %s\n%d distinct of %d, %s %% "
        "invalid\nMap: %d cells filled, quality %s\n%d creatures simulated, %s %% of the time "
        "saved",
        generation, pretty_number(stats.best).c_str(), pretty_number(stats.median).c_str(),
        pretty_number(stats.lower).c_str(), pretty_number(stats.upper).c_str(),
        stats.distinct_genomes, stats.size,
        pretty_number(std::round(100.0 * stats.invalid_share)).c_str(), stats.filled_cells,
        pretty_number(stats.quality).c_str(), stats.evaluations,
        pretty_number(std::round(100.0 * stats.time_saved)).c_str());
    tooltip(text + change_at(frame, generation) + "\n\nClick to watch its champion.");
}

}  // namespace cambrian
