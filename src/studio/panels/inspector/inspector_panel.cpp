#include "studio/panels/inspector/inspector_panel.h"

#include "studio/frame/help_mark.h"
#include "studio/panels/inspector/ancestry_tab.h"
#include "studio/panels/inspector/brain_tab.h"
#include "studio/panels/inspector/creature_tab.h"
#include "studio/panels/inspector/energy_tab.h"
#include "studio/panels/inspector/genotype_tab.h"
#include "studio/panels/inspector/lesions_tab.h"
#include "studio/widgets/widgets.h"

namespace cambrian {

InspectorPanel::InspectorPanel() {
    tabs_.push_back({"Creature", std::make_unique<CreatureTab>()});
    tabs_.push_back({"Brain", std::make_unique<BrainTab>()});
    tabs_.push_back({"Genotype", std::make_unique<GenotypeTab>()});
    tabs_.push_back({"Ancestry", std::make_unique<AncestryTab>()});
    tabs_.push_back({"Energy", std::make_unique<EnergyTab>()});
    tabs_.push_back({"Lesions", std::make_unique<LesionsTab>()});
}

void InspectorPanel::draw(const FrameContext& frame, Requests& out) {
    place_title("Inspector", "inspector", out);
    std::vector<std::string> titles;
    for (const Tab& tab : tabs_)
        titles.push_back(tab.title);
    const int pressed = segmented("inspector", titles, chosen_);
    if (pressed >= 0) chosen_ = pressed;
    ImGui::Dummy({0, px(2)});
    if (frame.viewer.playback.empty()) {
        muted_text("Nothing is displayed yet. Open a creature (Ctrl+O) or press Evolve.");
        return;
    }
    ImGui::BeginChild("tab", {0, 0}, false, ImGuiWindowFlags_NoBackground);
    tabs_[static_cast<std::size_t>(chosen_)].panel->draw(frame, out);
    if (ImGui::IsWindowHovered(ImGuiHoveredFlags_ChildWindows |
                               ImGuiHoveredFlags_AllowWhenBlockedByActiveItem |
                               ImGuiHoveredFlags_AllowWhenBlockedByPopup))
        out.ask(HoldShown{});
    ImGui::EndChild();
}

}  // namespace cambrian
