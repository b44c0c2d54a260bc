#include "studio/panels/preserve/museum_list.h"

#include "genome/creature_name.h"
#include "pictures/preserve/world_scene.h"
#include "preserve/world_time.h"
#include "studio/preserve/world_words.h"
#include "studio/widgets/creature_tile.h"
#include "studio/widgets/widgets.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

namespace cambrian {
namespace {

constexpr float kPieceHeight = 62.0F;  // of a row and the gap below it
constexpr float kPieceGap = 4.0F;
constexpr float kTileWidth = 72.0F;
constexpr int kMostPieceBodies = 4;  // bodies in a frame

void draw_buttons(Requests& out) {
    const float half = 0.5F * (ImGui::GetContentRegionAvail().x - px(6));
    if (push_button("View it alone", {.width = half,
                                      .tooltip = "Displays the chosen creature in the viewer, with "
                                                 "its brain and its genes (Enter)"}))
        out.ask(ShowPiece{});
    ImGui::SameLine(0, px(6));
    if (push_button("Save it…",
                    {.width = half, .tooltip = "As a creature file or a card (Shift+S)"}))
        out.ask(SavePiece{});
}

// Returns the colour of a founder's lineage in the world.
double hue_of(const MuseumPiece& piece) {
    return piece.reason == museum_reason::kLineage ? lineage_hue(piece.number) : piece.genome->hue;
}

// Scrolls the list so that a row is in view.
void scroll_to(std::size_t index) {
    const float top = static_cast<float>(index) * px(kPieceHeight);
    const float lowest = top + px(kPieceHeight) - ImGui::GetWindowHeight();
    ImGui::SetScrollY(std::clamp(ImGui::GetScrollY(), std::min(lowest, top), top));
}

}  // namespace

void MuseumList::draw(const FrameContext& frame, Requests& out) {
    if (frame.preserve->picture.museum->empty()) {
        muted_text(
            fmt::format("The founder of each lineage that reaches {} living members comes "
                        "here, and every 10 min of the world's time the living creature "
                        "with the most children.",
                        kMembersForMuseum));
        return;
    }
    draw_buttons(out);
    ImGui::BeginChild("pieces", {0, 0}, false, ImGuiWindowFlags_NoBackground);
    draw_pieces(frame, out);
    ImGui::EndChild();
}

void MuseumList::draw_pieces(const FrameContext& frame, Requests& out) {
    const PreserveView& preserve = *frame.preserve;
    bodies_.begin_frame(kMostPieceBodies);
    if (std::exchange(seen_, preserve.piece) != preserve.piece) scroll_to(preserve.piece);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, px(kPieceGap)));
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(preserve.picture.museum->size()), px(kPieceHeight));
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            const auto index = static_cast<std::size_t>(i);
            if (draw_piece(frame, index)) out.ask(ChoosePiece{index});
        }
    }
    ImGui::PopStyleVar();
}

// Returns true when it was pressed.
bool MuseumList::draw_piece(const FrameContext& frame, std::size_t index) {
    const PreserveView& preserve = *frame.preserve;
    const MuseumPiece& piece = (*preserve.picture.museum)[index];
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImVec2 size = {ImGui::GetContentRegionAvail().x, px(kPieceHeight - kPieceGap)};
    const std::string name = fmt::format("museum {} {}", piece.number, piece.reason);
    const bool pressed = ImGui::InvisibleButton(name.c_str(), size);
    note_place(name);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    Color back = index == preserve.piece ? mix(colors().raised, colors().accent, 0.3F)
                                         : mix(colors().panel, colors().raised, 0.6F);
    if (ImGui::IsItemHovered() && index != preserve.piece) back = colors().hovered;
    list.AddRectFilled(low, {low.x + size.x, low.y + size.y}, paint(back), px(5));
    const ExperimentSettings& laws = *preserve.picture.laws;
    const Phenotype* body =
        bodies_.find(piece.genome, frame.kinds.creature, laws.expression, laws.world.scene);
    if (body != nullptr)
        draw_creature_tile(list, {low.x + px(6), low.y + px(5), px(kTileWidth), size.y - px(10)},
                           *body, hue_of(piece),
                           piece.reason == museum_reason::kLineage ? piece.number : 0);
    const float left = low.x + px(kTileWidth + 14);
    const float room = size.x - px(kTileWidth + 20);
    list.AddText(
        {left, low.y + px(4)}, paint(colors().text),
        fit_text(fmt::format("{} {}", creature_name(*piece.genome), piece.number), room).c_str());
    const WithFont font(ui().fonts.small);
    list.AddText({left, low.y + px(23)}, paint(colors().text),
                 fit_text(capitalized(reason_words(piece)), room).c_str());
    list.AddText({left, low.y + px(39)}, paint(colors().muted),
                 fit_text("at " + world_time(piece.tick), room).c_str());
    return pressed;
}

}  // namespace cambrian
