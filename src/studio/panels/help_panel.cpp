#include "studio/panels/help_panel.h"

#include "studio/shortcuts.h"
#include "studio/widgets.h"

#include <array>

namespace cambrian {
namespace {

constexpr std::array kFirstSteps = {
    "Press Evolve: creatures are bred, tried in their world and selected, generation after "
    "generation. The best of the newest generation takes the stage.",
    "Change the world or the rules on the left at any time; the creature on show feels it at once, "
    "the next generation evolves under it, and the timeline marks it.",
    "Take hold of a creature with the mouse; drag with the right button to look around, scroll to "
    "come closer. Click the timeline to watch an earlier champion.",
    "Press H to select by hand: click the creatures you like in the grid and press Enter to breed "
    "the next one from them. Backspace goes back; nothing is lost.",
};

void draw_keys(const char* title, std::span<const Shortcut> keys) {
    ImGui::Dummy({0, px(6)});
    caption(title);
    if (!ImGui::BeginTable(title, 2, ImGuiTableFlags_SizingFixedFit)) return;
    for (const Shortcut& shortcut : keys) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        {
            const WithTextColor accent(colors().accent);
            ImGui::TextUnformatted(shortcut.keys);
        }
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(shortcut.what);
    }
    ImGui::EndTable();
}

}  // namespace

void HelpPanel::draw(const FrameContext&, Requests& out) {
    {
        const WithFont font(ui().fonts.title);
        ImGui::TextUnformatted("Keys and first steps");
    }
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - px(34));
    if (push_button("Close help", {.look = ButtonLook::kGhost,
                                   .icon = Icon::kClose,
                                   .label_shown = false,
                                   .width = px(34)}))
        out.ask(ToggleHelp{});
    ImGui::BeginChild("help", {0, 0}, false, ImGuiWindowFlags_NoBackground);
    for (const char* step : kFirstSteps) {
        ImGui::PushTextWrapPos(0.0F);
        ImGui::TextUnformatted(step);
        ImGui::PopTextWrapPos();
    }
    draw_keys("Everywhere", shortcuts());
    draw_keys("While picking by hand", picking_shortcuts());
    ImGui::EndChild();
}

}  // namespace cambrian
