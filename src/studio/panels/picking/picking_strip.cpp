#include "studio/panels/picking/picking_strip.h"

#include "studio/widgets/widgets.h"

#include <string>

namespace cambrian {
namespace {

constexpr float kNarrowStrip = 560.0F;  // width below which the buttons are closer together

bool is_narrow_strip() {
    return ImGui::GetWindowWidth() < px(kNarrowStrip);
}

float width_of(const char* label) {
    return ImGui::CalcTextSize(label).x + px(is_narrow_strip() ? 14 : 24);
}

bool ghost(const char* label, const char* hint, bool enabled = true, bool chosen = false) {
    return push_button(label, {.look = chosen ? ButtonLook::kSelected : ButtonLook::kGhost,
                               .width = width_of(label),
                               .enabled = enabled,
                               .tooltip = hint});
}

// A button for a step through the grids, with words if there is room, otherwise with an icon.
bool step(const char* label, Icon icon, const char* hint, bool enabled) {
    if (!is_narrow_strip()) return ghost(label, hint, enabled);
    return push_button(label, {.look = ButtonLook::kGhost,
                               .icon = icon,
                               .label_shown = false,
                               .width = px(30),
                               .enabled = enabled,
                               .tooltip = hint});
}

void draw_walk(const PickingView& picking, Requests& out) {
    const PickingTree& tree = picking.snapshot.tree;
    const bool any = !tree.empty();
    if (step("Back", Icon::kChevronLeft, "The grid before this one (Backspace); nothing is lost",
             any && (tree.current().parent || deciding(picking.snapshot))))
        out.ask(AskPicking{GoBack{}});
    ImGui::SameLine();
    if (step("Forward", Icon::kChevronRight,
             "To the grid last bred from this one (Shift+Backspace)",
             any && tree.next().has_value()))
        out.ask(AskPicking{GoForward{}});
}

void draw_focused(const PickingView& picking, Requests& out) {
    const PickingTree& tree = picking.snapshot.tree;
    const bool any = !tree.empty();
    if (ghost("View", "Show the creature in focus alone (V, or a double click)", any))
        out.ask(ShowCell{picking.focus});
    ImGui::SameLine();
    if (ghost("Keep", "Keep the creature in focus on the shelf (K, or drag it there)", any))
        out.ask(AskPicking{PinCreature{tree.current().number, picking.focus}});
    ImGui::SameLine();
    if (ghost("Save…", "Save the creature in focus to a file (S)", any))
        out.ask(SaveCell{picking.focus});
}

void draw_options(const PickingView& picking, Requests& out) {
    PickingOptions options = picking.options;
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - width_of("Scores") - width_of("Hints") -
                    px(4));
    if (ghost("Scores", "Write each creature's fitness into its cell", true, options.scores))
        options.scores = !options.scores;
    ImGui::SameLine();
    if (ghost("Hints", "Mark the fastest, the highest and the oddest creature", true,
              options.hints))
        options.hints = !options.hints;
    if (!(options == picking.options)) out.ask(ChangePickingOptions{options});
}

}  // namespace

void PickingStrip::draw(const FrameContext& frame, Requests& out) {
    const PickingView& picking = *frame.picking;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(px(4), 0));
    if (push_button("Move", {.look = ButtonLook::kGhost,
                             .icon = picking.playing ? Icon::kPause : Icon::kPlay,
                             .label_shown = false,
                             .width = px(34),
                             .tooltip = "Pause or resume all creatures (P)"}))
        out.ask(TogglePlayback{});
    const float gap = px(is_narrow_strip() ? 4 : 12);
    ImGui::SameLine(0, gap);
    draw_walk(picking, out);
    ImGui::SameLine(0, gap);
    draw_focused(picking, out);
    draw_options(picking, out);
    ImGui::PopStyleVar();
}

}  // namespace cambrian
