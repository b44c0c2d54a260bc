#include "studio/panels/preserve/preserve_panel.h"

#include "core/text/counted.h"
#include "pictures/preserve/world_scene.h"
#include "preserve/world_time.h"
#include "studio/frame/help_mark.h"
#include "studio/preserve/world_words.h"
#include "studio/widgets/creature_tile.h"
#include "studio/widgets/widgets.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace cambrian {
namespace {

constexpr float kRoomForList = 280.0F;  // the least height for buttons and list
constexpr float kLowList = 200.0F;

constexpr std::size_t kMostLineages = 40;
constexpr float kLineageHeight = 34.0F;

void draw_additions(const FrameContext& frame, Requests& out) {
    const float half = 0.5F * (ImGui::GetContentRegionAvail().x - px(6));
    const bool any = !frame.viewer.playback.empty();
    if (push_button("Add creature…",
                    {.width = half,
                     .tooltip = "A creature file or a card joins the world where "
                                "the view has its middle; the light pays (Ctrl+O)"}))
        out.ask(OpenFilePanel{FileTask::kOpen});
    ImGui::SameLine(0, px(6));
    if (push_button("Add the shown", {.width = half,
                                      .enabled = any,
                                      .tooltip = "A copy of the creature that the viewer displays "
                                                 "joins the world; the light pays (A)"}))
        out.ask(AddShown{});
}

void draw_tools(const PreserveView& preserve, Requests& out) {
    const float third = (ImGui::GetContentRegionAvail().x - px(12)) / 3.0F;
    if (push_button("Draw a wall",
                    {.look = preserve.wall.on ? ButtonLook::kSelected : ButtonLook::kPlain,
                     .width = third,
                     .tooltip = "Drag in the world, or click both ends; W sets an end where the "
                                "mouse points"}))
        out.ask(ToggleWalls{});
    ImGui::SameLine(0, px(6));
    if (push_button("Erase a wall", {.width = third,
                                     .enabled = !preserve.picture.walls.empty(),
                                     .tooltip = "The wall in the middle of the view; with X the "
                                                "one where the mouse points"}))
        out.ask(EraseWallThere{});
    ImGui::SameLine(0, px(6));
    if (push_button("Energy rings",
                    {.look = preserve.energy ? ButtonLook::kSelected : ButtonLook::kPlain,
                     .width = third,
                     .tooltip = "A ring around each creature shows its store. It is complete, and "
                                "green, when that is enough to bear a child (R)"}))
        out.ask(ToggleEnergyRings{});
}

// Draws a lineage as a bar of its share. Returns true when pressed.
bool draw_lineage(const LineageCount& lineage, const std::string& founder, std::size_t all) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImVec2 size = {ImGui::GetContentRegionAvail().x, px(kLineageHeight)};
    const std::string name = fmt::format("lineage {}", lineage.number);
    const bool pressed = ImGui::InvisibleButton(name.c_str(), size);
    note_place(name);
    const bool hovered = ImGui::IsItemHovered();
    tooltip("Pick its eldest living member (L goes through the lineages)");
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const double hue = lineage_hue(lineage.number);
    if (hovered)
        list.AddRectFilled(low, {low.x + size.x, low.y + size.y}, paint(colors().hovered), px(5));
    draw_creature_tile(list, {low.x + px(4), low.y + px(4), px(40), size.y - px(8)},
                       *lineage.phenotype, hue, lineage.number);
    const std::string members = counted(lineage.members, "creature");
    const WithFont font(ui().fonts.small);
    const float text = low.y + px(3);
    list.AddText({low.x + px(52), text}, paint(colors().text), ("of " + founder).c_str());
    list.AddText({low.x + size.x - ImGui::CalcTextSize(members.c_str()).x - px(6), text},
                 paint(colors().muted), members.c_str());
    const float left = low.x + px(52);
    const float room = size.x - px(58);
    const float share = static_cast<float>(lineage.members) / static_cast<float>(all);
    const float bar = low.y + size.y - px(9);
    list.AddRectFilled({left, bar}, {left + room, bar + px(4)}, paint(colors().raised), px(2));
    list.AddRectFilled({left, bar}, {left + std::max(px(4), room * share), bar + px(4)},
                       paint(color_of_hue(hue, 0.66, 0.12)), px(2));
    return pressed;
}

void draw_lineages(const PreservePicture& picture, Requests& out) {
    if (picture.residents.empty()) muted_text("Nobody is alive.");
    const std::vector<LineageCount> lineages = lineages_in(picture);
    for (std::size_t i = 0; i < std::min(lineages.size(), kMostLineages); ++i) {
        const std::string founder = called(picture, lineages[i].number);
        if (draw_lineage(lineages[i], founder, picture.residents.size()))
            out.ask(PickResident{lineages[i].eldest});
    }
    if (lineages.size() > kMostLineages)
        muted_text(fmt::format("and {} smaller ones", lineages.size() - kMostLineages));
}

// Draws the list of snapshots to go back to, the newest first.
void draw_snapshots(const PreservePicture& picture, float width, Requests& out) {
    const bool open = begin_choice("##back", "Go back to…", width);
    if (open) {
        const auto& ticks = *picture.snapshots;
        for (auto tick = ticks.rbegin(); tick != ticks.rend(); ++tick) {
            const std::string name = "back to " + world_time(*tick);
            if (choice_line(name, false)) out.ask(BranchFrom{*tick});
            note_place(name);
        }
        ImGui::EndCombo();
    }
    note_place("go back");
    if (!open)
        tooltip(
            "Goes on from a snapshot in a file of its own; the present world remains in its file "
            "(Ctrl+Z for the last one)");
}

void draw_file(const PreserveView& preserve, Requests& out) {
    ImGui::Dummy({0, px(2)});
    if (preserve.file.empty()) {
        return muted_text("It is not kept: the studio was started without a folder for its state.");
    }
    fact("Kept in", preserve.file.filename().string());
    const float half = 0.5F * (ImGui::GetContentRegionAvail().x - px(6));
    if (push_button("Keep elsewhere…",
                    {.width = half,
                     .tooltip = "Copies the preserve to another file and goes on there (Ctrl+K)"}))
        out.ask(OpenFilePanel{FileTask::kSavePreserve});
    ImGui::SameLine(0, px(6));
    ImGui::SetCursorPosY(ImGui::GetCursorPosY() + px(2));
    draw_snapshots(preserve.picture, half, out);
}

void draw_tabs(WorldList shown, Requests& out) {
    ImGui::Dummy({0, px(4)});
    const int pressed = segmented(
        "world lists", {kWorldListNames.begin(), kWorldListNames.end()}, static_cast<int>(shown),
        {"Who is related to whom (N)", "What can be changed while the world goes on (J)",
         "Creatures that are kept in sight after their death (G)"});
    if (pressed >= 0) out.ask(ShowList{static_cast<WorldList>(pressed)});
    ImGui::Dummy({0, px(2)});
}

}  // namespace

void PreservePanel::draw(const FrameContext& frame, Requests& out) {
    place_title("Preserve", "preserve", out);
    // If the list would have no room, it is scrolled along with the buttons.
    const bool low = ImGui::GetContentRegionAvail().y < px(kRoomForList);
    if (low) ImGui::BeginChild("preserve", {0, 0}, false, ImGuiWindowFlags_NoBackground);
    draw_additions(frame, out);
    draw_tools(*frame.preserve, out);
    draw_file(*frame.preserve, out);
    draw_tabs(frame.preserve->list, out);
    ImGui::BeginChild("world list", {0, low ? px(kLowList) : 0.0F}, false,
                      ImGuiWindowFlags_NoBackground);
    switch (frame.preserve->list) {
        case WorldList::kLineages:
            draw_lineages(frame.preserve->picture, out);
            break;
        case WorldList::kLaws:
            laws_.draw(frame, out);
            break;
        case WorldList::kMuseum:
            museum_.draw(frame, out);
    }
    ImGui::EndChild();
    if (low) ImGui::EndChild();
}

}  // namespace cambrian
