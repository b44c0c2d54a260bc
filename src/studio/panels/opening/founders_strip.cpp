#include "studio/panels/opening/founders_strip.h"

#include "studio/widgets/widgets.h"

#include <fmt/core.h>

namespace cambrian {

void FoundersStrip::draw(const FrameContext& frame, Requests& out) {
    const FounderCrowd& crowd = *frame.coach.founders;
    constexpr const char* others = "Other creatures";
    const bool running = frame.experiment.snapshot.status == EngineStatus::kRunning;
    const float width = ImGui::CalcTextSize(others).x + px(28);
    const float room = ImGui::GetContentRegionAvail().x - width - px(12);
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
    if (push_button(others, {.width = width,
                             .enabled = !running,
                             .tooltip = "Draw another seed, and with it other random creatures"}))
        out.ask(StartNewRun{});
}

}  // namespace cambrian
