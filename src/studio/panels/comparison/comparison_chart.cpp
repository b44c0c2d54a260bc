#include "studio/panels/comparison/comparison_chart.h"

#include "core/text/pretty_text.h"
#include "pictures/curves_picture.h"
#include "studio/widgets/plot.h"
#include "studio/widgets/widgets.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace cambrian {
namespace {

constexpr float kArmShade = 0.2F;

// Returns the ranges that hold all bands; none without points.
std::optional<PlotScale> scale_of(const ComparisonResults& results, const Rect& area) {
    double trials = 0.0;
    double least = 0.0;
    double most = 0.0;
    for (const ComparedArm& arm : results.arms) {
        for (std::size_t i = 0; i < arm.band.trials.size(); ++i) {
            trials = std::max(trials, arm.band.trials[i]);
            least = std::min(least, arm.band.lower[i]);
            most = std::max(most, arm.band.upper[i]);
        }
    }
    if (trials <= 0.0) return std::nullopt;
    const PlotRange range = plot_range(least, std::max(most, 1e-3));
    return PlotScale{area, 0.0, trials, range.low, range.high};
}

void tell_values(const ComparisonResults& results, const PlotScale& scale,
                 const std::string& unit) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    if (!ImGui::IsItemHovered() || !scale.area.contains(mouse)) return;
    const double trials = scale.x_from(mouse.x);
    std::string words = pretty_number(std::round(trials)) + " trials";
    for (const ComparedArm& arm : results.arms) {
        const auto& at = arm.band.trials;
        const auto found = std::lower_bound(at.begin(), at.end(), trials);
        if (found == at.end()) continue;
        const double middle = arm.band.middle[static_cast<std::size_t>(found - at.begin())];
        words += fmt::format("\n{}: {}", arm.name, with_unit(middle, unit));
    }
    ImGui::GetWindowDrawList()->AddLine({mouse.x, scale.area.y},
                                        {mouse.x, scale.area.y + scale.area.height},
                                        paint(colors().faint));
    ImGui::SetTooltip("%s", words.c_str());
}

}  // namespace

void draw_comparison_chart(const ComparisonResults& results, const std::string& unit,
                           float height) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    ImGui::InvisibleButton("comparison chart", {std::max(1.0F, width), std::max(1.0F, height)});
    note_place("comparison chart");
    const Rect area = {at.x + px(48), at.y + px(8), width - px(60), height - px(32)};
    if (area.width < px(40) || area.height < px(30)) return;
    const auto scale = scale_of(results, area);
    if (!scale) return;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    draw_axes(list, *scale);
    for (std::size_t i = 0; i < results.arms.size(); ++i) {
        const CurveBand& band = results.arms[i].band;
        draw_band(list, *scale, band.trials, band.lower, band.upper,
                  with_alpha(color_of_curve(i), kArmShade));
    }
    for (std::size_t i = 0; i < results.arms.size(); ++i) {
        const CurveBand& band = results.arms[i].band;
        draw_curve(list, *scale, band.trials, band.middle, color_of_curve(i), px(2));
    }
    tell_values(results, *scale, unit);
}

}  // namespace cambrian
