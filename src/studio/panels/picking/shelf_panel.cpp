#include "studio/panels/picking/shelf_panel.h"

#include "genome/creature_name.h"
#include "studio/frame/help_mark.h"
#include "studio/hand_picking/drag_payload.h"
#include "studio/widgets/creature_tile.h"
#include "studio/widgets/widgets.h"

#include <fmt/core.h>

#include <algorithm>

namespace cambrian {
namespace {

constexpr float kShelfWidth = 74.0F;
constexpr float kShelfHeight = 66.0F;
constexpr float kShelfGap = 6.0F;
constexpr int kShelfGrown = 8;

}  // namespace

void ShelfPanel::draw(const FrameContext& frame, Requests& out) {
    place_title("Shelf", "hand_picking", out);
    const auto& shelf = frame.picking->snapshot.shelf;
    bodies_.begin_frame(kShelfGrown);
    const ImVec2 room = ImGui::GetContentRegionAvail();
    ImGui::BeginChild("shelf", room, false, ImGuiWindowFlags_NoBackground);
    if (shelf.empty()) {
        ImGui::Dummy({0, px(6)});
        muted_text("Drag a creature here, or press K, to keep it whatever becomes of the grid.");
    }
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(px(kShelfGap), px(kShelfGap)));
    const int columns = tiles_across(room.x, px(kShelfWidth), px(kShelfGap));
    for (std::size_t place = 0; place < shelf.size(); ++place) {
        if (static_cast<int>(place) % columns != 0) ImGui::SameLine();
        draw_tile(place, frame, out);
    }
    ImGui::PopStyleVar();
    ImGui::EndChild();
    note_place("shelf");
    if (const auto creature = dropped_cell()) out.ask(AskPicking{*creature});
}

void ShelfPanel::draw_tile(std::size_t place, const FrameContext& frame, Requests& out) {
    const PickingSnapshot& snapshot = frame.picking->snapshot;
    const JudgedIndividual& pinned = snapshot.shelf[place];
    const std::string name = fmt::format("pin {}", place + 1);
    const ImVec2 size = {px(kShelfWidth), px(kShelfHeight)};
    const bool pressed = ImGui::InvisibleButton(name.c_str(), size);
    note_place(name);
    drag_pin(place);
    if (pressed && !snapshot.tree.empty())
        out.ask(
            AskPicking{PlacePinned{place, snapshot.tree.current().number, frame.picking->focus}});
    if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) out.ask(AskPicking{UnpinCreature{place}});
    const ImVec2 low = ImGui::GetItemRectMin();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const Color back =
        ImGui::IsItemHovered() ? colors().hovered : mix(colors().panel, colors().raised, 0.6F);
    list.AddRectFilled(low, ImGui::GetItemRectMax(), paint(back), px(5));
    const Rect body = {low.x + px(8), low.y + px(8), size.x - px(16), size.y - px(16)};
    const Phenotype* phenotype =
        bodies_.find(pinned.individual->genome, frame.kinds.creature, pinned.settings->expression,
                     pinned.settings->world.scene);
    if (phenotype != nullptr)
        draw_creature_tile(list, body, *phenotype, pinned.individual->genome->hue,
                           pinned.individual->line);
    tooltip(
        fmt::format("{}. Drag it into a cell of any grid, or click: it takes cell {}, the one in "
                    "focus. Right-click to take it off the shelf.",
                    creature_name(*pinned.individual->genome), frame.picking->focus + 1));
}

}  // namespace cambrian
