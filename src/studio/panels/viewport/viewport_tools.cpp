#include "studio/panels/viewport/viewport_tools.h"

#include "studio/actions/action_menu.h"
#include "studio/frame/change_view.h"
#include "studio/frame/help_mark.h"
#include "studio/look/overlays.h"
#include "studio/widgets/widgets.h"

namespace cambrian {
namespace {

// Draws one switch for each overlay. The menu stays open while several are switched.
void overlay_lines(const FrameContext& frame, Requests& out) {
    action_items("look-* | scenery-*", frame, out);
    ImGui::Separator();
    for (const OverlayKind& overlay : overlay_kinds()) {
        bool shown = frame.view.overlays.*overlay.shown;
        const bool switched = toggle_switch(overlay.label, shown);
        tooltip(overlay.help);
        ImGui::SameLine();
        ImGui::AlignTextToFramePadding();
        ImGui::TextUnformatted(overlay.label);
        tooltip(overlay.help);
        if (switched)
            change_view(frame, out, [&](ViewState& view) { view.overlays.*overlay.shown = shown; });
    }
}

void ghost_lines(const FrameContext& frame, Requests& out) {
    action_items("ghosts-* | rival", frame, out);
}

using Lines = void (*)(const FrameContext& frame, Requests& out);

void menu_button(const char* name, Icon icon, const char* help, bool lit, Lines lines,
                 const FrameContext& frame, Requests& out) {
    const bool open = ImGui::IsPopupOpen(name);
    if (push_button(name, {.look = lit || open ? ButtonLook::kSelected : ButtonLook::kGhost,
                           .icon = icon,
                           .label_shown = false,
                           .width = px(30),
                           .height = px(28),
                           .tooltip = help}))
        ImGui::OpenPopup(name);
    const ImVec2 corner = ImGui::GetItemRectMax();
    ImGui::SetNextWindowPos({corner.x, corner.y + px(4)}, ImGuiCond_Always, {1.0F, 0.0F});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(px(10), px(8)));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(px(14), px(8)));
    if (ImGui::BeginPopup(name)) {
        lines(frame, out);
        ImGui::EndPopup();
    }
    ImGui::PopStyleVar(2);
}

void pen_button(const FrameContext& frame, Requests& out) {
    if (push_button("Draw ground",
                    {.look = frame.viewer.ground_pen ? ButtonLook::kSelected : ButtonLook::kGhost,
                     .icon = Icon::kPencil,
                     .label_shown = false,
                     .width = px(30),
                     .height = px(28),
                     .enabled = frame.may_draw_ground(),
                     .tooltip = "Draw ground: each line that is dragged becomes the ground between "
                                "its ends (D)"}))
        out.ask(ToggleGroundPen{});
    ImGui::SameLine();
}

void drawing_button(const FrameContext& frame, Requests& out) {
    if (push_button("Draw creature",
                    {.look = frame.drawing() ? ButtonLook::kSelected : ButtonLook::kGhost,
                     .icon = Icon::kBody,
                     .label_shown = false,
                     .width = px(30),
                     .height = px(28),
                     .tooltip = "Draw this creature: add parts and change them with the mouse "
                                "(Shift+D)"}))
        out.ask(ToggleDrawing{});
    ImGui::SameLine();
}

}  // namespace

void draw_shown_actions(const FrameContext& frame, const ImVec2& at, Requests& out) {
    const ExperimentSettings& its = frame.viewer.playback.exhibit().settings();
    const ExperimentSettings& draft = frame.experiment.editor.draft();
    const bool elsewhere =
        its.goal != draft.goal || !(its.world.environment == draft.world.environment);
    const WithFont font(ui().fonts.small);
    ImGui::SetCursorScreenPos(at);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(px(6), px(4)));
    const auto action = [](const char* label, const char* help) {
        const bool pressed = push_button(label, {.height = px(26), .tooltip = help});
        ImGui::SameLine();
        return pressed;
    };
    if (action("Evolve from it",
               "A new run that begins with this creature and random ones, for the goal and in the "
               "world of the experiment. Ctrl+Z goes back to the run before."))
        out.ask(EvolveShown{false});
    if (elsewhere &&
        action("Evolve in its world",
               "The same, for the goal and in the world in which this creature is judged"))
        out.ask(EvolveShown{true});
    if (!frame.in_space() &&
        action("Into a preserve", "Copies of it begin a closed world that goes on by itself"))
        out.ask(BeginPreserve{FounderChoice::kShown, false});
    if (its.world.trial.trials > 1 &&
        action("Next trial",
               "Another of the trials that its score combines (Shift+.); the one "
               "before: Shift+,"))
        out.ask(TurnTrial{1});
    if (action("Save it", "In a file of its own, or as a card (Ctrl+S)"))
        out.ask(OpenFilePanel{FileTask::kSaveCreature});
    ImGui::NewLine();
    ImGui::PopStyleVar();
}

void draw_viewport_tools(const FrameContext& frame, const Rect& area, Requests& out) {
    const bool draws = frame.viewer.ground_pen || frame.may_draw_ground();
    const float buttons = 2.0F + (draws ? 1.0F : 0.0F) + (frame.may_draw_creature() ? 1.0F : 0.0F);
    const float width =
        frame.window.viewer_only ? px(30) : px(30) * buttons + px(24) + px(4) * buttons;
    const ImVec2 at = {area.x + area.width - width - px(10), area.y + px(10)};
    // A plate, so that they are seen before any sky.
    ImGui::GetWindowDrawList()->AddRectFilled({at.x - px(4), at.y - px(2)},
                                              {at.x + width + px(4), at.y + px(32)},
                                              paint(with_alpha(colors().panel, 0.6F)), px(6));
    ImGui::SetCursorScreenPos(at);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(px(4), px(4)));
    if (!frame.window.viewer_only) {
        if (frame.may_draw_creature()) drawing_button(frame, out);
        if (draws) pen_button(frame, out);
        menu_button("Ghosts", Icon::kGhost, "Champions of other generations beside this one",
                    frame.view.ghosts != GhostChoice::kNone, ghost_lines, frame, out);
        ImGui::SameLine();
    }
    menu_button("Overlays", Icon::kEye, "Overlays drawn over the creature", false, overlay_lines,
                frame, out);
    if (!frame.window.viewer_only) {
        ImGui::SameLine();
        ImGui::SetCursorPosY(ImGui::GetCursorPosY() + px(3));
        help_mark(frame.drawing() ? "drawing" : "viewport", out);
    }
    ImGui::PopStyleVar();
}

LookMode shown_look(const FrameContext& frame) {
    const OverlaysShown& over = frame.view.overlays;
    const bool inside = over.forces || over.torques || over.limits || over.sensors || over.names ||
                        frame.viewer.playback.creature().hold() != nullptr;
    return frame.view.look == LookMode::kLife && inside ? LookMode::kGlass : frame.view.look;
}

}  // namespace cambrian
