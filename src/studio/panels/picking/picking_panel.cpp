#include "studio/panels/picking/picking_panel.h"

#include "core/text/pretty_text.h"
#include "studio/frame/help_mark.h"
#include "studio/widgets/widgets.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>

namespace cambrian {
namespace {

constexpr std::array kGenerations = {5, 10, 25, 50};

void picking_section(const char* title) {
    ImGui::Dummy({0, px(2)});
    caption(title);
}

bool wide_button(const char* label, const char* hint, bool enabled, float width = 0.0F) {
    return push_button(label, {.width = width > 0.0F ? width : ImGui::GetContentRegionAvail().x,
                               .enabled = enabled,
                               .tooltip = hint});
}

void draw_size(GridSettings& grid) {
    picking_section("Creatures in the grid");
    std::vector<std::string> labels;
    std::vector<std::string> hints;
    int chosen = -1;
    for (std::size_t i = 0; i < kGridSizes.size(); ++i) {
        const int columns = grid_columns(kGridSizes[i]);
        labels.push_back(std::to_string(kGridSizes[i]));
        hints.push_back(fmt::format("{} by {}, from the next grid on", columns,
                                    (kGridSizes[i] + columns - 1) / columns));
        if (kGridSizes[i] == grid.cells) chosen = static_cast<int>(i);
    }
    const int pressed = segmented("cells", labels, chosen, hints);
    if (pressed >= 0) grid.cells = kGridSizes[static_cast<std::size_t>(pressed)];
}

void draw_boldness(GridSettings& grid) {
    picking_section("Strength of mutation");
    const int pressed =
        segmented("boldness", {"Gentle", "Bold", "Wild"}, static_cast<int>(grid.boldness),
                  {"Most children show exactly one change.", "One mutation more in every child.",
                   "Three mutations more in every child, and a few random creatures besides."});
    if (pressed >= 0) grid.boldness = static_cast<Boldness>(pressed);
}

void draw_dial(GridSettings& grid) {
    picking_section("Choice of the children shown");
    auto percent = static_cast<int>(100.0 * grid.fitness_weight + 0.5);
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
    const char* pattern = percent == 0     ? "all difference"
                          : percent == 100 ? "all fitness"
                                           : "%d %% fitness";
    if (ImGui::SliderInt("##dial", &percent, 0, 100, pattern, ImGuiSliderFlags_AlwaysClamp))
        grid.fitness_weight = 0.01 * percent;
    note_place("dial");
    tooltip(
        "The share of fitness in the choice. With 0 %, the children shown differ as much as "
        "possible; with 100 %, they are the fittest.");
}

void draw_evolving(const PickingView& picking, Requests& out) {
    const PickingSnapshot& snapshot = picking.snapshot;
    progress_bar(picking.progress, 0, px(7));
    muted_text(
        fmt::format("{} of {} generations", snapshot.generations_done, snapshot.generations_asked));
    if (wide_button("Cancel", "Stop evolution and keep this grid", true))
        out.ask(AskPicking{CancelDecision{}});
}

void draw_generations(const PickingView& picking, Requests& out) {
    std::vector<std::string> labels;
    int chosen = -1;
    for (std::size_t i = 0; i < kGenerations.size(); ++i) {
        labels.push_back(fmt::format("×{}", kGenerations[i]));
        if (kGenerations[i] == picking.options.assisted_generations) chosen = static_cast<int>(i);
    }
    const int pressed = segmented("generations", labels, chosen);
    if (pressed < 0) return;
    PickingOptions options = picking.options;
    options.assisted_generations = kGenerations[static_cast<std::size_t>(pressed)];
    out.ask(ChangePickingOptions{options});
}

void draw_assistance(const PickingView& picking, Requests& out) {
    picking_section("Generations of evolution from the picks");
    if (picking.snapshot.status == PickingStatus::kEvolving) return draw_evolving(picking, out);
    draw_generations(picking, out);
    ImGui::SameLine();
    const bool ready = !picking.snapshot.picks.empty() && !deciding(picking.snapshot);
    if (wide_button("Assist",
                    "Sixty creatures bred from the picks evolve under the goal; the next grid "
                    "shows the best and most different of them (G)",
                    ready))
        out.ask(AskPicking{AskEvolution{picking.options.assisted_generations}});
}

void draw_way_back(const PickingView& picking, Requests& out) {
    picking_section("Back to automatic evolution");
    const bool any = !picking.snapshot.picks.empty();
    const float half = 0.5F * (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x);
    if (wide_button("Inject picks",
                    "The picks take the places of the worst in the next generation that is bred",
                    any, half))
        out.ask(HandOverPicks{PicksUse::kInject});
    ImGui::SameLine();
    if (wide_button("New run", "A new generation 0, with the picks among its founders", any))
        out.ask(HandOverPicks{PicksUse::kFound});
}

}  // namespace

void PickingPanel::draw(const FrameContext& frame, Requests& out) {
    const PickingView& picking = *frame.picking;
    place_title("Next grid", "hand_picking", out);
    ImGui::BeginChild("picking", {0, 0}, false, ImGuiWindowFlags_NoBackground);
    GridSettings grid = picking.snapshot.grid;
    draw_size(grid);
    draw_boldness(grid);
    draw_dial(grid);
    if (!(grid == picking.snapshot.grid)) out.ask(AskPicking{ChangeGrid{grid}});
    ImGui::Dummy({0, px(3)});
    const bool open = !picking.snapshot.tree.empty() && !deciding(picking.snapshot);
    if (wide_button("Random creatures for the rest",
                    "Random creatures replace those not picked (R)", open))
        out.ask(AskPicking{ReplaceUnpicked{}});
    draw_assistance(picking, out);
    draw_way_back(picking, out);
    ImGui::Dummy({0, px(3)});
    if (wide_button("Grid from the creature on display",
                    "A grid of children of the creature last viewed or opened (Ctrl+O)",
                    !frame.viewer.playback.empty()))
        out.ask(AskPicking{StartFromCreatures{{frame.viewer.playback.exhibit().genome()}}});
    ImGui::EndChild();
}

}  // namespace cambrian
