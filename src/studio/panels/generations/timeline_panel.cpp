#include "studio/panels/generations/timeline_panel.h"

#include "core/text/pretty_text.h"
#include "core/text/shown_score.h"
#include "genome/creature_name.h"
#include "studio/actions/action_menu.h"
#include "studio/frame/change_view.h"
#include "studio/frame/help_mark.h"
#include "studio/widgets/widgets.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace cambrian {
namespace {

constexpr float kMarkReach = 5.0F;  // distance to a mark within which its text is shown
constexpr int kLongStride = 10;     // generations per key press with Shift

void draw_quantities(const FrameContext& frame, Requests& out) {
    const TimelinePlot& chosen = timeline_plot(frame.view.quantity);
    const bool open =
        begin_choice("##quantity", timeline_title(chosen, frame.unit_of_goal()), px(128));
    note_place("timeline quantity");
    if (!open) return tooltip("The quantity plotted (Up, Down). " + std::string(chosen.what));
    for (const TimelinePlot& plot : timeline_plots()) {
        if (choice_line(plot.name, &plot == &chosen)) {
            change_view(frame, out, [&](ViewState& view) { view.quantity = plot.quantity; });
        }
        note_place(plot.name);
        tooltip(plot.what);
    }
    ImGui::EndCombo();
}

void draw_heading(const FrameContext& frame, Requests& out) {
    place_title("Timeline", "timeline", out);
    const WithFont font(ui().fonts.small);
    ImGui::SameLine(0, px(10));
    draw_quantities(frame, out);
    ImGui::SameLine();
    const float after = ImGui::GetCursorPosX();
    const float height = ImGui::GetFrameHeight();
    const float export_width = px(62);
    const float right = ImGui::GetWindowContentRegionMax().x - px(kHelpMarkRoom);
    const TimelinePlot& plot = timeline_plot(frame.view.quantity);
    const float legend_right = right - export_width - px(12);
    if (legend_right - legend_width(plot) > after) {
        const ImVec2 corner = ImGui::GetWindowPos();
        draw_legend(*ImGui::GetWindowDrawList(), plot,
                    {corner.x + legend_right,
                     ImGui::GetCursorScreenPos().y + 0.5F * (height - ImGui::GetFontSize())});
    }
    ImGui::SameLine(right - export_width);
    if (push_button("Export", {.look = ButtonLook::kGhost,
                               .width = export_width,
                               .height = height,
                               .tooltip = "The statistics as a table, or this plot as a picture"}))
        ImGui::OpenPopup("export");
}

// Says that the best fitness has not risen for long (evolution/README.md 3).
void draw_stagnation(const FrameContext& frame, Requests& out) {
    const auto& history = frame.experiment.snapshot.history;
    if (history.empty() || !stagnant(history.back())) return;
    const WithFont font(ui().fonts.small);
    ImGui::AlignTextToFramePadding();
    muted_text(fmt::format("The best has not risen for {} generations.",
                           history.back().generations_without_progress));
    ImGui::SameLine(0, px(10));
    if (push_button("What to change", {.height = ImGui::GetFrameHeight(),
                                       .tooltip = "Suggestions, each of which is one click"}))
        out.ask(ShowSuggestions{!frame.coach.suggestions});
}

// Returns the settings in which two journal entries differ, with both values, one per line.
std::string difference(const FrameContext& frame, const ExperimentSettings& before,
                       const ExperimentSettings& after) {
    ExperimentSettings a = before;
    ExperimentSettings b = after;
    std::string text;
    for (const SettingField& field : frame.experiment.fields) {
        if (same_value(field, a, b)) continue;
        text += fmt::format("\n{} {} → {}", field.label, value_text(field, field.at(a)),
                            value_text(field, field.at(b)));
    }
    return text;
}

// Returns what changed at the mark nearest to a pixel, if one is near enough.
std::string change_near(const FrameContext& frame, const PlotScale& scale, float pixel) {
    const auto& journal = frame.experiment.snapshot.journal;
    float nearest = px(kMarkReach);
    std::string text;
    for (std::size_t i = 1; i < journal.size(); ++i) {
        const auto generation = static_cast<double>(journal[i].generation);
        const float away = std::fabs(scale.x_at(generation) - pixel);
        if (generation > scale.x_high || away > nearest) continue;
        const bool same_mark = journal[i].generation == journal[i - 1].generation && !text.empty();
        if (!same_mark) text = fmt::format("Changed at generation {}:", journal[i].generation);
        text += difference(frame, *journal[i - 1].settings, *journal[i].settings);
        nearest = away;
    }
    return text;
}

std::string percent(double share) {
    return pretty_number(std::round(100.0 * share)) + " %";
}

std::string reading(const GenerationStatistics& stats, const std::string& unit) {
    std::string text =
        fmt::format("Generation {}\nBest {}", stats.generation, shown_score(stats.best, unit));
    if (stats.best_lowest < stats.best_highest) {
        text += fmt::format(" ({} to {} in other worlds)", shown_score(stats.best_lowest, ""),
                            shown_score(stats.best_highest, ""));
    }
    text += ", median " + shown_score(stats.median, "");
    text += fmt::format("\n10–90 %: {} to {}", shown_score(stats.lower, ""),
                        shown_score(stats.upper, ""));
    text += fmt::format("\n{} distinct of {}, ", stats.distinct_genomes, stats.size);
    text += fmt::format("{} founder lines and {} body plans survive, {} invalid", stats.lines,
                        stats.plans, percent(stats.invalid_share));
    text += fmt::format("\nOn average {} parts, {} neurons", pretty_number(stats.mean_parts),
                        pretty_number(stats.mean_neurons));
    text += fmt::format("\nMap: {} cells filled, quality {}", stats.filled_cells,
                        pretty_number(stats.quality));
    return text + fmt::format("\n{} trials, {} to confirm, {} of the time saved", stats.evaluations,
                              stats.confirmations, percent(stats.time_saved));
}

// Returns the time that the evaluation of a generation took; empty if unknown.
std::string wall_time_words(const EvolutionSnapshot& snapshot, std::size_t row) {
    if (row >= snapshot.wall_times.size() || snapshot.wall_times[row] <= 0.0) return "";
    return "\nEvaluated in " + with_unit(snapshot.wall_times[row], "s");
}

// Returns the row whose champion is displayed, or -1.
int shown_row(const FrameContext& frame) {
    if (frame.viewer.playback.empty()) return -1;
    const Exhibit& exhibit = frame.viewer.playback.exhibit();
    if (exhibit.source != ExhibitSource::kChampion) return -1;
    const auto& history = frame.experiment.snapshot.history;
    const auto found = std::lower_bound(history.begin(), history.end(), exhibit.creature.generation,
                                        [](const GenerationStatistics& row, std::uint32_t wanted) {
                                            return row.generation < wanted;
                                        });
    const bool known = found != history.end() && found->generation == exhibit.creature.generation;
    return known ? static_cast<int>(found - history.begin()) : -1;
}

// Returns whether the row's champion is displayed as it was bred, with no gene edited.
bool shows_champion(const FrameContext& frame, std::size_t row) {
    if (shown_row(frame) != static_cast<int>(row)) return false;
    const GenomePtr& genome = frame.viewer.playback.exhibit().genome();
    const auto& champions = frame.experiment.snapshot.champions;
    return std::any_of(champions.begin(), champions.end(), [&](const JudgedIndividual& each) {
        return each.individual->genome == genome;
    });
}

void draw_line(const PlotScale& scale, double generation, const Color& color) {
    const float x = std::floor(scale.x_at(generation)) + 0.5F;
    const Rect& area = scale.area;
    ImGui::GetWindowDrawList()->AddLine({x, area.y}, {x, area.y + area.height}, paint(color),
                                        px(1));
}

// Draws the cursor: a line with a grip that names the displayed generation.
void draw_cursor(const PlotScale& scale, double generation, const std::string& words) {
    draw_line(scale, generation, colors().text);
    const WithFont font(ui().fonts.small);
    const ImVec2 size = ImGui::CalcTextSize(words.c_str());
    const float width = size.x + px(10);
    const Rect& area = scale.area;
    const float x =
        std::clamp(scale.x_at(generation) - 0.5F * width, area.x, area.x + area.width - width);
    const ImVec2 low = {std::floor(x), std::floor(area.y - px(8))};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(low, {low.x + width, low.y + size.y + px(3)}, paint(colors().text), px(4));
    list.AddText({low.x + px(5), low.y + px(1)}, paint(colors().panel), words.c_str());
}

}  // namespace

void TimelinePanel::draw(const FrameContext& frame, Requests& out) {
    draw_heading(frame, out);
    action_popup("export", "export-*", frame, out);
    draw_stagnation(frame, out);
    chart_.gather(frame.experiment.snapshot, frame.view.quantity);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const Rect area = {at.x + px(46), at.y + px(8), room.x - px(54), room.y - px(28)};
    if (area.height < px(20) || area.width < px(20)) return;
    if (chart_.empty()) muted_text("Press Evolve: each finished generation adds a point here.");
    ImGui::SetCursorScreenPos(area.low());
    ImGui::InvisibleButton("plot", {area.width, area.height});
    note_place("timeline");
    if (chart_.empty()) return;
    const PlotScale scale = chart_.scale_for(area);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    draw_axes(list, scale);
    draw_change_marks(list, scale, frame.experiment.snapshot);
    chart_.draw(list, scale);
    chart_.draw_goals(list, scale, frame.kinds.goals);
    follow_mouse(scale, frame, out);
    follow_keys(frame, out);
}

void TimelinePanel::follow_mouse(const PlotScale& scale, const FrameContext& frame,
                                 Requests& out) const {
    const auto& history = frame.experiment.snapshot.history;
    const float pixel = ImGui::GetIO().MousePos.x;
    const std::size_t row = chart_.row_at(scale, pixel);
    const bool held = ImGui::IsItemActive();
    const bool hovered = ImGui::IsItemHovered();
    const int shown = held ? static_cast<int>(row) : shown_row(frame);
    if (held || hovered) {
        if (!held) draw_line(scale, chart_.generation(row), with_alpha(colors().text, 0.3F));
        chart_.draw_dots(*ImGui::GetWindowDrawList(), scale, row);
    }
    if (shown >= 0) {
        const std::uint32_t generation = history[static_cast<std::size_t>(shown)].generation;
        draw_cursor(scale, generation, std::to_string(generation));
    }
    if (held && !shows_champion(frame, row)) out.ask(ShowChampion{history[row].generation});
    if (held || !hovered) return;
    const std::string goal = goal_in(frame.experiment.snapshot, history[row].generation);
    std::string text = reading(history[row], goal_unit(goal, frame.kinds.goals)) +
                       wall_time_words(frame.experiment.snapshot, row);
    for (const JudgedIndividual& champion : frame.experiment.snapshot.champions) {
        if (champion.generation == history[row].generation)
            text += "\nChampion: " + creature_name(champion.genome());
    }
    const std::string change = change_near(frame, scale, pixel);
    if (!change.empty()) text += "\n\n" + change;
    tooltip(text + "\n\nClick or drag to watch champions; Left and Right step through them.");
}

void TimelinePanel::follow_keys(const FrameContext& frame, Requests& out) const {
    if (!ImGui::IsWindowFocused() || ImGui::GetIO().WantTextInput) return;
    const auto pressed = [](ImGuiKey key) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key)); };
    const int last = static_cast<int>(frame.experiment.snapshot.history.size()) - 1;
    const int stride = ImGui::GetIO().KeyShift ? kLongStride : 1;
    const int steps = pressed(ImGuiKey_RightArrow)  ? stride
                      : pressed(ImGuiKey_LeftArrow) ? -stride
                                                    : 0;
    const int shown = shown_row(frame);
    const int row = (shown < 0 ? last : shown) + steps;
    if (steps != 0 && row > last) out.ask(ShowNewest{});
    if (steps != 0 && row <= last) {
        const auto wanted = static_cast<std::size_t>(std::max(0, row));
        out.ask(ShowChampion{frame.experiment.snapshot.history[wanted].generation});
    }
    const int turn = pressed(ImGuiKey_DownArrow) ? 1 : pressed(ImGuiKey_UpArrow) ? -1 : 0;
    if (turn == 0) return;
    const int count = static_cast<int>(timeline_plots().size());
    change_view(frame, out, [&](ViewState& view) {
        view.quantity =
            static_cast<TimelineQuantity>((static_cast<int>(view.quantity) + turn + count) % count);
    });
}

}  // namespace cambrian
