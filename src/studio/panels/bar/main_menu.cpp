#include "studio/panels/bar/main_menu.h"

#include "studio/look/overlays.h"
#include "studio/panels/generations/export_menu.h"
#include "studio/panels/viewport/viewport_tools.h"
#include "studio/widgets/keyboard_focus.h"
#include "studio/widgets/widgets.h"

#include <array>
#include <cfloat>

namespace cambrian {
namespace {

void draw_preserve_items(const FrameContext& frame, Requests& out) {
    const bool open = frame.preserve != nullptr;
    const bool kept = open && !frame.preserve->file.empty();
    if (menu_item("New preserve…", "Ctrl+N")) out.ask(TogglePreserveCard{});
    if (menu_item("Add creature to preserve…", frame.world_shown() ? "Ctrl+O" : nullptr,
                  frame.world_shown()))
        out.ask(OpenFilePanel{FileTask::kOpen});
    if (menu_item("Keep preserve in another file…", frame.world_shown() ? "Ctrl+K" : nullptr, kept))
        out.ask(OpenFilePanel{FileTask::kSavePreserve});
    if (menu_item("Close preserve", "Ctrl+W", open)) out.ask(ClosePreserve{});
}

// Saves what Ctrl+S saves: the picked creature of the world, the one in focus in the grid, or the
// one on display.
void draw_save_creature_item(const FrameContext& frame, Requests& out) {
    constexpr const char* label = "Save creature…";
    constexpr const char* keys = "Ctrl+S";
    if (frame.world_shown()) {
        if (menu_item(label, keys, frame.preserve->picked != nullptr)) out.ask(SaveResident{});
    } else if (frame.grid_shown()) {
        const bool any = !frame.picking->snapshot.tree.empty();
        if (menu_item(label, keys, any)) out.ask(SaveCell{frame.picking->focus});
    } else if (menu_item(label, keys, !frame.viewer.playback.empty())) {
        out.ask(OpenFilePanel{FileTask::kSaveCreature});
    }
}

void draw_file_menu(const FrameContext& frame, Requests& out) {
    if (menu_item("Open…", "Ctrl+O")) out.ask(OpenFilePanel{FileTask::kOpen});
    if (menu_item("Samples…", "Ctrl+Shift+O")) out.ask(ToggleSamples{});
    if (menu_item("Open the run before", nullptr, frame.experiment.previous_run))
        out.ask(OpenPreviousRun{});
    ImGui::Separator();
    draw_preserve_items(frame, out);
    ImGui::Separator();
    draw_save_creature_item(frame, out);
    if (menu_item("Save experiment…", frame.world_shown() ? nullptr : "Ctrl+K"))
        out.ask(OpenFilePanel{FileTask::kSaveExperiment});
    if (menu_item("Save settings…", "Ctrl+Shift+S"))
        out.ask(OpenFilePanel{FileTask::kSaveSettings});
    draw_export_items(frame, out);
    if (menu_item("Save picture of the window", "F12")) out.ask(SaveScreenshot{});
    ImGui::Separator();
    if (menu_item("Compare settings…", "Ctrl+D")) out.ask(ToggleComparison{});
    if (menu_item("Work on several machines…", "Ctrl+M")) out.ask(ToggleMachines{});
    ImGui::Separator();
    if (menu_item("Quit", "Ctrl+Q")) out.ask(QuitStudio{});
}

void draw_edit_menu(const FrameContext& frame, Requests& out) {
    // Behind a world the edits are hidden, and Ctrl+Z goes back to a snapshot.
    const bool seen = !frame.world_shown();
    if (menu_item("Undo", seen ? "Ctrl+Z" : nullptr, seen && frame.can_undo())) out.ask(UndoEdit{});
    if (menu_item("Redo", seen ? "Ctrl+Shift+Z" : nullptr, seen && frame.can_redo()))
        out.ask(RedoEdit{});
    if (menu_item("Find a setting", "Ctrl+F")) out.ask(FindSetting{});
    ImGui::Separator();
    if (menu_item("New run", nullptr)) out.ask(StartNewRun{});
    if (menu_item("New run with the same seed", nullptr)) out.ask(StartNewRun{.same_seed = true});
    const bool any = !frame.experiment.snapshot.population.empty();
    if (menu_item("New run from these creatures", nullptr, any)) out.ask(StartNewRun{true});
    if (menu_item("New run from the creature on display", nullptr, !frame.viewer.playback.empty()))
        out.ask(StartFromShown{});
}

// A menu item that toggles one flag of the view.
void view_item(const char* label, const char* keys, const std::function<bool&(ViewState&)>& flag,
               const FrameContext& frame, Requests& out) {
    ViewState view = frame.view;
    bool& on = flag(view);
    if (!menu_item(label, keys, true, on)) return;
    on = !on;
    out.ask(ChangeView{view});
}

void fit_into_view(const FrameContext& frame, Requests& out) {
    if (frame.world_shown()) {
        out.ask(FitWorld{});
    } else {
        out.ask(FitView{});
    }
}

void draw_view_menu(const FrameContext& frame, Requests& out) {
    const bool picking = frame.picking != nullptr;
    if (menu_item("Pick by hand", "H", true, picking)) out.ask(ToggleHandPicking{});
    ImGui::Separator();
    view_item(
        "Experiment", nullptr, [](ViewState& view) -> bool& { return view.panels.left; }, frame,
        out);
    view_item(
        "Inspector", nullptr, [](ViewState& view) -> bool& { return view.panels.right; }, frame,
        out);
    view_item(
        "Timeline and population", nullptr,
        [](ViewState& view) -> bool& { return view.panels.bottom; }, frame, out);
    ImGui::Separator();
    view_item(
        "Follow the creature", "F", [](ViewState& view) -> bool& { return view.follow; }, frame,
        out);
    view_item(
        "Show each new champion", nullptr,
        [](ViewState& view) -> bool& { return view.newest_champion; }, frame, out);
    if (menu_item("Fit into view", "Home")) fit_into_view(frame, out);
    ImGui::Separator();
    for (const OverlayKind& overlay : overlay_kinds())
        view_item(
            overlay.label, nullptr,
            [&](ViewState& view) -> bool& { return view.overlays.*overlay.shown; }, frame, out);
    ImGui::Separator();
    look_lines(frame, out);
    ImGui::Separator();
    ghost_lines(frame, out);
    ImGui::Separator();
    const bool light = frame.view.theme == ThemeKind::kLight;
    if (menu_item("Light theme", "Ctrl+L", true, light)) {
        ViewState view = frame.view;
        view.theme = light ? ThemeKind::kDark : ThemeKind::kLight;
        out.ask(ChangeView{view});
    }
}

void draw_help_menu(const FrameContext&, Requests& out) {
    if (menu_item("Help", "F1")) out.ask(ToggleHelp{});
    if (menu_item("Keys", nullptr)) out.ask(ShowHelp{kKeysPage});
    if (menu_item("Tour of the window", nullptr)) out.ask(TurnTour{0});
    ImGui::Separator();
    if (menu_item("About Cambrian", nullptr)) out.ask(ShowHelp{kAboutPage});
}

struct Menu {
    const char* title;
    void (*draw)(const FrameContext& frame, Requests& out);
};
constexpr std::array kMenus = {Menu{"File", draw_file_menu}, Menu{"Edit", draw_edit_menu},
                               Menu{"View", draw_view_menu}, Menu{"Help", draw_help_menu}};

bool any_menu_open() {
    for (const Menu& menu : kMenus) {
        if (ImGui::IsPopupOpen(menu.title)) return true;
    }
    return false;
}

}  // namespace

void draw_main_menu(const FrameContext& frame, Requests& out) {
    const bool browsing = any_menu_open();
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(px(2), px(8)));
    for (const Menu& menu : kMenus) {
        ButtonStyle style;
        style.look = ImGui::IsPopupOpen(menu.title) ? ButtonLook::kSelected : ButtonLook::kGhost;
        style.width = ImGui::CalcTextSize(menu.title).x + px(20);
        style.height = px(34);
        const bool pressed = push_button(menu.title, style);
        const bool slid_over =
            browsing && ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenBlockedByPopup);
        if (pressed || slid_over) ImGui::OpenPopup(menu.title);
        const ImVec2 below = {ImGui::GetItemRectMin().x, ImGui::GetItemRectMax().y + px(4)};
        ImGui::SameLine();
        ImGui::SetNextWindowPos(below);
        const float room = ImGui::GetIO().DisplaySize.y - below.y - px(8);
        ImGui::SetNextWindowSizeConstraints({0, 0}, {FLT_MAX, room});
        ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(px(10), px(8)));
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(px(18), px(8)));
        if (ImGui::BeginPopup(menu.title)) {
            begin_focus_layer();
            menu.draw(frame, out);
            ImGui::EndPopup();
        }
        ImGui::PopStyleVar(2);
    }
    ImGui::PopStyleVar();
    ImGui::NewLine();
    ImGui::SameLine();
}

}  // namespace cambrian
