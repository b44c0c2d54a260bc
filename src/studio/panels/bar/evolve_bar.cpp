#include "studio/panels/bar/evolve_bar.h"

#include "core/text/pretty_text.h"
#include "core/text/shown_score.h"
#include "studio/experiment/timeline_plots.h"
#include "studio/panels/bar/bar_reading.h"
#include "studio/panels/bar/main_menu.h"
#include "studio/panels/bar/preserve_bar.h"
#include "studio/widgets/widgets.h"

#include <fmt/core.h>

#include <cmath>

namespace cambrian {
namespace {

std::string done_words(const FrameContext& frame) {
    const ProgressView& progress = frame.experiment.progress;
    if (progress.total > 0)
        return fmt::format("{} of {} creatures", pretty_number(progress.done),
                           pretty_number(progress.total));
    const std::size_t kept = frame.experiment.snapshot.history.size();
    if (kept == 0) return "nothing evaluated yet";
    return kept == 1 ? "1 generation kept" : fmt::format("{} generations kept", kept);
}

bool has_short_bar() {
    return ImGui::GetWindowWidth() < px(860);
}

int choose_mode(const std::vector<std::string>& labels, int chosen) {
    int pressed = -1;
    const bool open = begin_choice("##mode", labels[static_cast<std::size_t>(chosen)], px(112));
    if (!open) note_place("mode");
    for (int i = 0; open && i < static_cast<int>(labels.size()); ++i) {
        const std::string& label = labels[static_cast<std::size_t>(i)];
        if (choice_line(label, i == chosen)) pressed = i;
        note_place(label);
    }
    if (open) ImGui::EndCombo();
    return pressed;
}

std::string best_text(const FrameContext& frame) {
    const EvolutionSnapshot& snapshot = frame.experiment.snapshot;
    if (snapshot.history.empty()) return "–";
    const GenerationStatistics& last = snapshot.history.back();
    return shown_score(last.best, goal_unit(goal_in(snapshot, last.generation), frame.kinds.goals));
}

}  // namespace

void EvolveBar::draw(const FrameContext& frame, Requests& out) {
    draw_main_menu(frame, out);
    ImGui::SameLine(0, px(18));
    const float top = ImGui::GetCursorPosY();
    ImGui::SetCursorPosY(top + px(3));  // the choice of modes is lower than the buttons beside it
    draw_modes(frame, out);
    ImGui::SameLine(0, px(18));
    ImGui::SetCursorPosY(top);
    if (frame.preserve != nullptr) {
        draw_preserve_bar(frame, out);
    } else if (frame.picking != nullptr) {
        draw_breeding(frame, out);
        ImGui::SameLine(0, px(24));
        draw_picking(frame);
    } else {
        draw_buttons(frame, out);
        ImGui::SameLine(0, px(24));
        draw_numbers(frame);
    }
}

// Draws the choice between automatic evolution, selection by hand and the preserve.
void EvolveBar::draw_modes(const FrameContext& frame, Requests& out) {
    const int chosen = frame.preserve != nullptr ? 2 : frame.picking != nullptr ? 1 : 0;
    const std::vector<std::string> labels = {"Automatic", "Hand-pick", "Preserve"};
    const std::vector<std::string> tooltips = {
        "Fitness selects who breeds (H)", "You select who breeds, from a grid of creatures (H)",
        "A closed world in which creatures feed, breed and die by themselves (Ctrl+N)"};
    const int pressed =
        has_short_bar() ? choose_mode(labels, chosen) : segmented("mode", labels, chosen, tooltips);
    if (pressed < 0 || pressed == chosen) return;
    if (pressed == 2) return out.ask(TogglePreserveCard{});
    if (chosen == 2) out.ask(ClosePreserve{});
    if (pressed == 1 || chosen == 1) out.ask(ToggleHandPicking{});
}

void EvolveBar::draw_breeding(const FrameContext& frame, Requests& out) {
    const PickingSnapshot& snapshot = frame.picking->snapshot;
    ButtonStyle main;
    main.look = ButtonLook::kPrimary;
    main.width = px(118);
    main.height = px(34);
    const WithFont font(ui().fonts.strong);
    if (frame.picking->single) {
        main.tooltip = "Esc";
        main.width = 0.0F;
        if (push_button("Back to the grid", main)) out.ask(ShowGrid{});
    } else if (deciding(snapshot)) {
        main.look = ButtonLook::kPlain;
        main.tooltip = "Stop breeding and keep this grid (Backspace)";
        main.enabled = !snapshot.tree.empty();
        if (push_button("Stop", main)) out.ask(AskPicking{CancelDecision{}});
    } else {
        main.enabled = !snapshot.picks.empty();
        main.tooltip = "The next grid from the picks (Enter)";
        if (push_button("Breed", main)) out.ask(AskPicking{BreedPicks{}});
    }
}

void EvolveBar::draw_picking(const FrameContext& frame) {
    const PickingSnapshot& snapshot = frame.picking->snapshot;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    float x = at.x;
    const auto reading = [&](const std::string& value, const std::string& name, float least) {
        if (x + px(least) > at.x + ImGui::GetContentRegionAvail().x) return;
        x += std::fmax(px(least), draw_reading({x, at.y - px(1)}, value, name) + px(22));
    };
    const std::size_t grids = snapshot.tree.size();
    reading(grids == 0 ? "–" : fmt::format("{} of {}", snapshot.tree.current().number + 1, grids),
            "grid", 84);
    reading(fmt::format("{} of {}", snapshot.picks.size(), kMostPicks), "picked", 72);
    const float width = at.x + ImGui::GetContentRegionAvail().x - x;
    const Color color = snapshot.message.empty() ? colors().muted : colors().danger;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (deciding(snapshot)) {
        ImGui::SetCursorScreenPos({x, at.y + px(5)});
        progress_bar(frame.picking->progress, std::fmin(width, px(420)), px(7));
        list.AddText(ui().fonts.small, 13.0F * ui().scale, {x, at.y + px(16)}, paint(color),
                     picking_words(snapshot).c_str());
        return;
    }
    const std::string words =
        frame.picking->single ? "Esc leads back to the grid" : picking_words(snapshot);
    list.AddText({x, at.y + px(7)}, paint(color), fit_text(words, width).c_str());
}

void EvolveBar::draw_buttons(const FrameContext& frame, Requests& out) {
    const bool running = frame.experiment.snapshot.status == EngineStatus::kRunning;
    ButtonStyle main;
    main.look = ButtonLook::kPrimary;
    main.icon = running ? Icon::kPause : Icon::kPlay;
    main.width = px(118);
    main.height = px(34);
    main.tooltip = "Space";
    {
        const WithFont font(ui().fonts.strong);
        if (push_button(running ? "Pause" : "Evolve", main)) out.ask(ToggleEvolution{});
    }
    ImGui::SameLine();
    ButtonStyle step;
    step.icon = Icon::kStep;
    step.height = px(34);
    step.label_shown = !has_short_bar();
    step.enabled = !running;
    step.tooltip = "Evaluate and breed one generation, then pause (G)";
    if (push_button("Step one generation", step)) out.ask(RunOneGeneration{});
}

void EvolveBar::draw_numbers(const FrameContext& frame) {
    const ProgressView& progress = frame.experiment.progress;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float right = at.x + ImGui::GetContentRegionAvail().x;
    float x = at.x;
    const float y = at.y - px(1);
    const auto reading = [&](const std::string& value, const std::string& name, float least) {
        if (x + px(least) <= right)
            x += std::fmax(px(least), draw_reading({x, y}, value, name) + px(22));
    };
    reading(pretty_number(frame.experiment.snapshot.generation), "generation", 96);
    reading(best_text(frame), "best fitness", 110);
    const float speed_width = px(178);
    const float bar_width = std::fmin(right - x - speed_width, px(420));
    if (bar_width < px(60)) return;
    const float share = progress.total == 0 ? 0.0F
                                            : static_cast<float>(progress.done) /
                                                  static_cast<float>(progress.total);
    const float bar_y = at.y + px(5);
    ImGui::SetCursorScreenPos({x, bar_y});
    progress_bar(share, bar_width, px(7));
    ImGui::GetWindowDrawList()->AddText(ui().fonts.small, 13.0F * ui().scale, {x, at.y + px(16)},
                                        paint(colors().muted), done_words(frame).c_str());
    x += bar_width + px(22);
    const bool known = progress.per_second > 0.0;
    reading(known ? pretty_number(std::round(progress.per_second)) : "–", "creatures/s", 92);
    reading(progress.seconds_left >= 0.0 ? pretty_time(progress.seconds_left) : "–", "left", 40);
}

}  // namespace cambrian
