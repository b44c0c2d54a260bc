#include "studio/panels/inspector/sense_section.h"

#include "studio/widgets/widgets.h"

#include <fmt/core.h>

#include <algorithm>
#include <string>
#include <vector>

namespace cambrian {
namespace {

std::string left_of(double left, double intact) {
    return fmt::format("{:.0f} % left", 100.0 * std::clamp(left / intact, 0.0, 9.99));
}

std::string label_of(const SenseLoss& loss, const SensorRegistry& sensors) {
    for (const SensorKind& kind : sensors.all()) {
        for (const SensorChannel& channel : kind.channels)
            if (channel.id == loss.channel) return channel.label;
    }
    return loss.channel;
}

void draw_losses(const FrameContext& frame, const SenseLosses& losses, Requests& out) {
    if (!(losses.intact > 0.0))
        return muted_text("It has no score to lose in trials that no generation has seen.");
    const bool needed = losses.without_all <= kNeededShare * losses.intact;
    const WithTextColor color(needed ? colors().accent : colors().muted);
    ImGui::TextUnformatted(needed ? "It needs its senses" : "It does as well without its senses");
    tooltip(
        "Judged in eight trials that no generation has seen: each sense reads the constant "
        "that leaves most of the score.");
    fact("Without all", left_of(losses.without_all, losses.intact));
    std::vector<SenseLoss> sorted = losses.each;
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const SenseLoss& a, const SenseLoss& b) { return a.score < b.score; });
    for (const SenseLoss& loss : sorted) {
        fact(fmt::format("{}, part {}", label_of(loss, frame.kinds.creature.sensors), loss.part),
             left_of(loss.score, losses.intact));
        if (ImGui::IsItemHovered()) out.ask(ShowHighlight{{.part = static_cast<int>(loss.part)}});
    }
}

}  // namespace

void draw_senses(const FrameContext& frame, Requests& out) {
    const bool hears = !frame.viewer.playback.creature().phenotype().sensors.empty();
    if (!hears || frame.viewer.senses == nullptr) return;
    section("Senses");
    const SenseStudy& study = *frame.viewer.senses;
    if (study.running()) {
        muted_text("Its trials are run without its senses…");
        progress_bar(static_cast<float>(study.share()), 0.0F, px(6));
        if (push_button("Stop", {.height = px(26)})) out.ask(StopSenseStudy{});
    } else if (study.losses() != nullptr) {
        draw_losses(frame, *study.losses(), out);
    } else if (push_button("Weigh its senses",
                           {.height = px(26),
                            .tooltip = "How much of the score is left if each sense reads its "
                                       "best constant, all together and each alone"})) {
        out.ask(StudySenses{});
    }
}

}  // namespace cambrian
