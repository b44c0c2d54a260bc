#include "studio/panels/opening/founders_strip.h"

#include "studio/widgets/widgets.h"

#include <fmt/core.h>

namespace cambrian {

void FoundersStrip::draw(const FrameContext& frame, Requests& out) {
    const FounderCrowd& crowd = *frame.coach.founders;
    constexpr const char* others = "Other creatures";
    constexpr const char* own = "Draw your own";
    const bool running = frame.experiment.snapshot.status == EngineStatus::kRunning;
    const float width = ImGui::CalcTextSize(others).x + px(28);
    const float own_width = ImGui::CalcTextSize(own).x + px(28);
    const float room = ImGui::GetContentRegionAvail().x - width - own_width - px(18);
    const float left = ImGui::GetCursorPosX();
    const std::string words = fmt::format(
        "The first {} of {} creatures. Each has the world for itself; click one to "
        "see its body and brain.",
        crowd.founders().size(), crowd.settings()->population.size);
    ImGui::AlignTextToFramePadding();
    {
        const WithFont font(ui().fonts.small);
        const WithTextColor muted(colors().muted);
        ImGui::TextUnformatted(fit_text(words, room).c_str());
        tooltip(words);
    }
    ImGui::SameLine(left + room + px(12));
    if (push_button(own, {.width = own_width,
                          .enabled = frame.may_draw_creature(),
                          .tooltip = "Draw a body with the mouse, give it a rhythm and evolve it"}))
        out.ask(DrawNewCreature{});
    ImGui::SameLine(0, px(6));
    if (push_button(others, {.width = width,
                             .enabled = !running,
                             .tooltip = "Draw another seed, and with it other random creatures"}))
        out.ask(StartNewRun{});
}

}  // namespace cambrian
