#include "studio/panels/population_panel.h"

#include "studio/creature_tile.h"
#include "studio/help_mark.h"
#include "studio/text.h"
#include "studio/widgets.h"

#include <algorithm>

namespace cambrian {
namespace {

constexpr float kTileWidth = 74.0F;
constexpr float kTileHeight = 76.0F;
constexpr float kTileGap = 6.0F;
constexpr int kGrownAFrame = 20;

std::string tile_words(const Individual& individual, std::size_t rank) {
    const EvaluationResult& result = individual.result;
    std::string text = format("Rank %zu\n", rank + 1);
    if (result.outcome == Outcome::kCompleted) {
        text += "Fitness " + pretty_number(result.fitness);
    } else {
        text += capitalized(std::string(outcome_name(result.outcome)));
        if (!result.reason.empty()) text += ": " + result.reason;
    }
    text += format("\n%d parts, %d neurons", result.parts, result.neurons);
    text += "\nBorn in generation " + std::to_string(individual.born) + " by " + individual.method;
    return text;
}

bool on_show(const FrameContext& frame, const Individual& individual) {
    return !frame.playback.empty() && frame.playback.exhibit().genome == individual.genome;
}

}  // namespace

void PopulationPanel::draw(const FrameContext& frame, Requests& out) {
    const ImVec2 corner = ImGui::GetCursorPos();
    ImGui::SetCursorPosX(ImGui::GetWindowContentRegionMax().x - px(24));
    help_mark("timeline", out);
    ImGui::SetCursorPos(corner);
    panel_title("Population");
    const auto& population = frame.snapshot.population;
    if (population.empty()) {
        ImGui::Dummy({0, px(6)});
        muted_text("The creatures of the newest finished generation stand here, best first.");
        return;
    }
    {
        const WithFont font(ui().fonts.small);
        const WithTextColor muted(colors().muted);
        ImGui::SameLine(0, px(10));
        ImGui::Text("generation %u, best first", frame.snapshot.history.back().generation);
    }
    bodies_.begin_frame(kGrownAFrame);
    ImGui::BeginChild("tiles", {0, 0}, false, ImGuiWindowFlags_NoBackground);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(px(kTileGap), px(kTileGap)));
    const float room = ImGui::GetContentRegionAvail().x;
    const int columns =
        std::max(1, static_cast<int>((room + px(kTileGap)) / px(kTileWidth + kTileGap)));
    const int rows = (static_cast<int>(population.size()) + columns - 1) / columns;
    ImGuiListClipper clipper;
    clipper.Begin(rows, px(kTileHeight + kTileGap));
    while (clipper.Step()) {
        for (int row = clipper.DisplayStart; row < clipper.DisplayEnd; ++row) {
            for (int column = 0; column < columns; ++column) {
                const auto rank =
                    static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                    static_cast<std::size_t>(column);
                if (rank >= population.size()) break;
                if (column > 0) ImGui::SameLine();
                draw_tile(rank, frame, out);
            }
        }
    }
    ImGui::PopStyleVar();
    ImGui::EndChild();
}

void PopulationPanel::draw_tile(std::size_t rank, const FrameContext& frame, Requests& out) {
    const IndividualPtr& individual = frame.snapshot.population[rank];
    const std::string name = format("tile %zu", rank);
    if (ImGui::InvisibleButton(name.c_str(), {px(kTileWidth), px(kTileHeight)})) {
        out.ask(ShowIndividual{individual});
    }
    if (rank < 4) note_place(name);
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const bool shown = on_show(frame, *individual);
    list.AddRectFilled(low, high,
                       paint(ImGui::IsItemHovered() ? colors().hovered
                                                    : mix(colors().panel, colors().raised, 0.6F)),
                       px(5));
    if (shown) list.AddRect(low, high, paint(colors().accent), px(5), ImDrawFlags_None, px(2));
    const bool valid = individual->result.outcome == Outcome::kCompleted;
    const ExperimentSettings& settings = *frame.snapshot.settings;
    const Rect body = {low.x + px(8), low.y + px(8), px(kTileWidth - 16), px(kTileHeight - 32)};
    const Phenotype* phenotype = bodies_.find(individual->genome, frame.kinds.creature,
                                              settings.expression, settings.world.scene);
    if (phenotype != nullptr) draw_creature_tile(list, body, *phenotype, individual->genome->hue);
    const float size = 12.0F * ui().scale;
    const std::string score =
        valid ? pretty_number(individual->result.fitness) : std::string("invalid");
    const float width = ui().fonts.small->CalcTextSizeA(size, 1e6F, 0.0F, score.c_str()).x;
    list.AddText(ui().fonts.small, size, {0.5F * (low.x + high.x - width), high.y - px(18)},
                 paint(valid ? colors().muted : colors().danger), score.c_str());
    tooltip(tile_words(*individual, rank));
}

}  // namespace cambrian
