#include "studio/panels/inspector/energy_tab.h"

#include "core/text/pretty_text.h"
#include "studio/widgets/plot.h"
#include "studio/widgets/widgets.h"

#include <algorithm>
#include <array>

namespace cambrian {
namespace {

constexpr float kPlotHeight = 150.0F;

// One of the forms into which the muscles' work went. The plot stacks them in this order.
struct EnergyShare {
    const char* label;
    const char* help;
    double EnergySample::*value;
    Color (*color)();
};

constexpr std::array kShares = {
    EnergyShare{"Lost to drag", "The energy that the medium took from moving parts.",
                &EnergySample::drag, [] { return colors().plot_median; }},
    EnergyShare{"Lost to friction, impacts",
                "The energy that sliding contacts, impacts and the stops of joints took.",
                &EnergySample::contacts, [] { return colors().plot_best; }},
    EnergyShare{"Stored",
                "The kinetic and potential energy beyond that at the start. Below zero, the "
                "creature uses what it had.",
                &EnergySample::stored, [] { return colors().accent; }},
    EnergyShare{"Unexplained",
                "The energy that the audit does not account for: rounding, or your hand if you "
                "pulled at the creature.",
                &EnergySample::unexplained, [] { return colors().danger; }},
};

struct Band {
    std::vector<double> lower;
    std::vector<double> upper;

    void add(double low, double high) {
        lower.push_back(low);
        upper.push_back(high);
    }
};

// The two bands of a share, above and below zero, since its sign may change.
struct Stack {
    Band above;
    Band below;
};
using Stacks = std::array<Stack, kShares.size()>;

// Stacks gains above zero and losses below it.
Stacks stack_up(const std::vector<EnergySample>& samples) {
    Stacks stacks;
    for (const EnergySample& sample : samples) {
        double above = 0.0;
        double below = 0.0;
        for (std::size_t i = 0; i < kShares.size(); ++i) {
            const double value = sample.*kShares[i].value;
            const double top = above + std::max(value, 0.0);
            const double bottom = below + std::min(value, 0.0);
            stacks[i].above.add(above, top);
            stacks[i].below.add(bottom, below);
            above = top;
            below = bottom;
        }
    }
    return stacks;
}

PlotRange energy_range(const Stacks& stacks) {
    const Stack& outermost = stacks.back();
    double low = 0.0;
    double high = 0.0;
    for (const double bottom : outermost.below.lower)
        low = std::min(low, bottom);
    for (const double top : outermost.above.upper)
        high = std::max(high, top);
    return plot_range(low, high);
}

void draw_plot(const std::vector<EnergySample>& samples, double duration) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    ImGui::Dummy({width, px(kPlotHeight + 24)});
    note_place("energy");
    const Stacks stacks = stack_up(samples);
    const PlotRange range = energy_range(stacks);
    const PlotScale scale{{at.x + px(44), at.y + px(6), width - px(52), px(kPlotHeight - 6)},
                          0.0,
                          duration,
                          range.low,
                          range.high};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    draw_axes(list, scale, " s");
    std::vector<double> times;
    std::vector<double> work;
    for (const EnergySample& sample : samples) {
        times.push_back(sample.time);
        work.push_back(sample.muscles);
    }
    for (std::size_t i = 0; i < kShares.size(); ++i) {
        const Color color = with_alpha(kShares[i].color(), 0.75F);
        for (const Band* band : {&stacks[i].above, &stacks[i].below})
            draw_band(list, scale, times, band->lower, band->upper, color);
    }
    if (!times.empty()) draw_curve(list, scale, times, work, colors().text, px(1.5F));
}

void legend_row(const char* label, const char* help, const Color& color, double value) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const ImVec2 size = {ImGui::GetContentRegionAvail().x, ImGui::GetTextLineHeight()};
    ImGui::Dummy(size);
    tooltip(help);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float middle = at.y + 0.5F * size.y;
    list.AddRectFilled({at.x, middle - px(5)}, {at.x + px(10), middle + px(5)}, paint(color),
                       px(2));
    list.AddText({at.x + px(18), at.y}, paint(colors().muted), label);
    const std::string words = measured(value, "J");
    list.AddText({at.x + size.x - ImGui::CalcTextSize(words.c_str()).x, at.y}, paint(colors().text),
                 words.c_str());
}

void draw_verdict(AuditVerdict verdict) {
    const WithTextColor color(verdict == AuditVerdict::kClean ? colors().accent : colors().danger);
    ImGui::TextUnformatted(capitalized(std::string(verdict_name(verdict))).c_str());
    tooltip(
        "Clean: contacts, limits and rounding gave the creature a negligible energy and spin. "
        "Suspect: they may not be negligible. Invalid: the motion could not be computed.");
}

std::string share_text(double work, double scale) {
    return scale > 0.0 ? with_unit(100.0 * work / scale, "%") : measured(work, "J");
}

void draw_audit(const FrameContext& frame) {
    section("Audit of the trial");
    if (frame.viewer.score == nullptr) return muted_text("The trial is being run again…");
    const SceneAudit& audit = frame.viewer.score->record.audit;
    draw_verdict(judge(frame.viewer.score->record));
    // The net work is the sum of what was lost, stored and not explained.
    const EnergySample sum = energy_sample(0.0, audit);
    fact("Net muscle work", measured(sum.muscles, "J"));
    fact("Gross muscle work", measured(audit.gross_motor_work, "J"));
    fact("Lost to drag", measured(sum.drag, "J"));
    fact("Lost to contacts, limits", measured(sum.contacts, "J"));
    fact("Stored", measured(sum.stored, "J"));
    fact("Unexplained", share_text(audit.energy_residual, audit.energy_scale));
    fact("Gained from contacts", share_text(audit.positive_work, audit.energy_scale));
    fact("Spin gained from nothing",
         with_unit(audit.spin_scale > 0.0 ? 100.0 * audit.spin_gained / audit.spin_scale : 0.0,
                   "%"));
    fact("Deepest penetration", measured(1e3 * audit.max_penetration, "mm"));
    fact("Largest limit violation", measured(audit.max_limit_overrun, "rad"));
    fact("Fastest part", measured(audit.max_part_speed, "m/s"));
    section("Computation");
    fact("Evaluations", std::to_string(audit.evaluations));
    fact("Steps", std::to_string(audit.steps));
    fact("Rejected steps", std::to_string(audit.rejections));
    fact("Impacts", std::to_string(audit.events));
    fact("Solver fallbacks", std::to_string(audit.fallbacks));
}

}  // namespace

void EnergyTab::draw(const FrameContext& frame, Requests&) {
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(px(8), px(5)));
    muted_text("Joules over seconds of the trial, as it is played. The line is the muscles' work.");
    const std::vector<EnergySample>& samples =
        frame.viewer.playback.creature().readings().energy().samples();
    draw_plot(samples, frame.viewer.playback.trial().world().trial.duration);
    const EnergySample now = samples.empty() ? EnergySample{} : samples.back();
    legend_row("Work of the muscles", "Net: what they gave minus what they absorbed.",
               colors().text, now.muscles);
    for (const EnergyShare& share : kShares)
        legend_row(share.label, share.help, share.color(), now.*share.value);
    draw_audit(frame);
    ImGui::PopStyleVar();
}

}  // namespace cambrian
