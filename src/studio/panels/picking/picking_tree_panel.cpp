#include "studio/panels/picking/picking_tree_panel.h"

#include "core/text/counted.h"
#include "core/text/pretty_text.h"
#include "studio/frame/help_mark.h"
#include "studio/widgets/creature_tile.h"
#include "studio/widgets/widgets.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace cambrian {
namespace {

constexpr float kTileSize = 48.0F;
constexpr float kColumnStep = 66.0F;
constexpr float kRowStep = 58.0F;
constexpr int kTreeGrown = 8;

std::string grid_words(const GridNode& grid) {
    return fmt::format("Grid {}\n{}\n{} creatures", grid.number + 1,
                       capitalized(origin_words(grid)), grid.creatures.size());
}

// Returns the creature that represents a grid: the first pick from which another grid was bred,
// else its first creature.
const IndividualPtr& face_of(const PickingTree& tree, std::uint32_t number) {
    const GridNode& grid = tree.node(number);
    for (std::uint32_t later = number + 1; later < tree.size(); ++later) {
        const GridNode& child = tree.node(later);
        if (child.parent == number && !child.picks.empty() &&
            child.picks.front() < grid.creatures.size())
            return grid.creatures[child.picks.front()];
    }
    return grid.creatures.front();
}

void draw_link(ImDrawList& list, const Rect& from, const Rect& to) {
    const ImU32 color = paint(colors().faint);
    const ImVec2 start = {from.x + from.width, from.center().y};
    const ImVec2 end = {to.x, to.center().y};
    const float middle = std::round(end.x - px(8));
    list.AddLine(start, {middle, start.y}, color, px(1.5F));
    list.AddLine({middle, start.y}, {middle, end.y}, color, px(1.5F));
    list.AddLine({middle, end.y}, end, color, px(1.5F));
}

}  // namespace

void PickingTreePanel::draw(const FrameContext& frame, Requests& out) {
    const PickingTree& tree = frame.picking->snapshot.tree;
    place_title("Grids so far", "hand_picking", out);
    {
        const WithFont font(ui().fonts.small);
        const WithTextColor muted(colors().muted);
        ImGui::SameLine(0, px(10));
        const PickingSnapshot& picking = frame.picking->snapshot;
        const std::string counts = fmt::format(
            "{}, {} {}", counted(static_cast<std::size_t>(picking.decisions), "decision"),
            picking.branches, picking.branches == 1 ? "branch" : "branches");
        ImGui::TextUnformatted(counts.c_str());
    }
    bodies_.begin_frame(kTreeGrown);
    ImGui::BeginChild("map", {0, 0}, false,
                      ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_HorizontalScrollbar);
    if (!tree.empty()) draw_map(frame, out);
    ImGui::EndChild();
}

void PickingTreePanel::draw_map(const FrameContext& frame, Requests& out) {
    const PickingTree& tree = frame.picking->snapshot.tree;
    const std::vector<MapPlace> places = lay_out_map(tree);
    const ImVec2 origin = ImGui::GetCursorScreenPos();
    const auto tile_of = [&](std::uint32_t number) {
        return Rect{origin.x + px(2) + px(kColumnStep) * static_cast<float>(places[number].column),
                    origin.y + px(2) + px(kRowStep) * static_cast<float>(places[number].row),
                    px(kTileSize), px(kTileSize)};
    };
    for (std::uint32_t number = 0; number < tree.size(); ++number) {
        const std::optional<std::uint32_t> parent = tree.node(number).parent;
        if (parent) draw_link(*ImGui::GetWindowDrawList(), tile_of(*parent), tile_of(number));
    }
    for (std::uint32_t number = 0; number < tree.size(); ++number)
        draw_grid(number, tile_of(number), frame, out);
    keep_in_sight(tree.current().number, tile_of(tree.current().number));
}

void PickingTreePanel::draw_grid(std::uint32_t number, const Rect& tile, const FrameContext& frame,
                                 Requests& out) {
    const PickingTree& tree = frame.picking->snapshot.tree;
    const GridNode& grid = tree.node(number);
    const std::string name = fmt::format("grid {}", number + 1);
    ImGui::SetCursorScreenPos(tile.low());
    if (ImGui::InvisibleButton(name.c_str(), {tile.width, tile.height}))
        out.ask(AskPicking{VisitGrid{number}});
    if (!ImGui::IsItemVisible()) return;
    note_place(name);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const bool current = tree.current().number == number;
    const Color back =
        ImGui::IsItemHovered() ? colors().hovered : mix(colors().panel, colors().raised, 0.6F);
    list.AddRectFilled(tile.low(), tile.high(), paint(back), px(5));
    const IndividualPtr& face = face_of(tree, number);
    const Phenotype* body = bodies_.find(face->genome, frame.kinds.creature,
                                         grid.settings->expression, grid.settings->world.scene);
    const Rect inside = {tile.x + px(6), tile.y + px(5), tile.width - px(12), tile.height - px(20)};
    if (body != nullptr) draw_creature_tile(list, inside, *body, face->genome->hue, face->line);
    const std::string label = std::to_string(number + 1);
    const float size = 12.0F * ui().scale;
    const float width = ui().fonts.small->CalcTextSizeA(size, 1e6F, 0.0F, label.c_str()).x;
    list.AddText(ui().fonts.small, size,
                 {std::round(tile.center().x - 0.5F * width), tile.high().y - px(15)},
                 paint(current ? colors().text : colors().muted), label.c_str());
    if (current)
        list.AddRect(tile.low(), tile.high(), paint(colors().accent), px(5), ImDrawFlags_None,
                     px(2));
    tooltip(grid_words(grid));
}

// Scrolls the map when another grid is displayed.
void PickingTreePanel::keep_in_sight(std::uint32_t current, const Rect& tile) {
    if (seen_ == current) return;
    seen_ = current;
    ImGui::SetScrollFromPosX(tile.center().x - ImGui::GetWindowPos().x, 0.7F);
    ImGui::SetScrollFromPosY(tile.center().y - ImGui::GetWindowPos().y, 0.5F);
}

}  // namespace cambrian
