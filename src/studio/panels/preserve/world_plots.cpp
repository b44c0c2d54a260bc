#include "studio/panels/preserve/world_plots.h"

#include "core/text/pretty_text.h"
#include "preserve/world_time.h"
#include "studio/frame/help_mark.h"
#include "studio/widgets/plot.h"
#include "studio/widgets/widgets.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <vector>

namespace cambrian {
namespace {

constexpr float kRoomForCaption = 420.0F;  // beside the legend of energies

using Number = double (*)(const SeriesRow& row);

// Colours of the colour-blind-safe set of Okabe & Ito, readable on both themes.
const Color kGreen = color_of(0x009E73);
const Color kBlue = color_of(0x3C8DC5);
const Color kOrange = color_of(0xD99A00);
const Color kRed = color_of(0xD55E00);
const Color kPink = color_of(0xCC79A7);

struct Curve {
    const char* label;
    Color color;
    Number number;
};

struct WorldPlot {
    const char* title;
    const char* help;
    std::vector<Curve> curves;
};

template <auto Member>
double member(const SeriesRow& row) {
    return static_cast<double>(row.*Member);
}

const std::array<WorldPlot, kWorldPlotCount>& world_plots() {
    static const std::array<WorldPlot, kWorldPlotCount> plots = {
        WorldPlot{"Population",
                  "Creatures alive",
                  {{"creatures", kGreen, member<&SeriesRow::population>}}},
        WorldPlot{"Lineages",
                  "Lineages with living members",
                  {{"lineages", kBlue, member<&SeriesRow::lineages>}}},
        WorldPlot{"Births",
                  "Arrivals in 10 s",
                  {{"births", kGreen, member<&SeriesRow::births>},
                   {"stillborn", kPink, member<&SeriesRow::stillborn>},
                   {"restocked", kBlue, member<&SeriesRow::restocked>}}},
        WorldPlot{"Deaths",
                  "Deaths in 10 s, by cause",
                  {{"hunger", kOrange, member<&SeriesRow::hunger>},
                   {"eaten", kRed, member<&SeriesRow::eaten>},
                   {"broken physics", kPink, member<&SeriesRow::broken_physics>}}},
        WorldPlot{"Traits",
                  "Means over the living",
                  {{"mass, kg", kBlue, member<&SeriesRow::mass>},
                   {"speed, m/s", kGreen, member<&SeriesRow::speed>},
                   {"diet", kRed, member<&SeriesRow::diet>}}},
    };
    return plots;
}

const std::array<Curve, 5>& energy_pools() {
    static const std::array<Curve, 5> pools = {
        Curve{"bodies", kPink, member<&SeriesRow::bodies>},
        Curve{"stores", kBlue, member<&SeriesRow::stores>},
        Curve{"flesh", kRed, member<&SeriesRow::flesh>},
        Curve{"plants", kGreen, member<&SeriesRow::plants>},
        Curve{"light", kOrange, member<&SeriesRow::light>},
    };
    return pools;
}

// Draws the names of curves at the right end of the panel's heading.
void draw_legend(std::span<const Curve> curves) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const WithFont font(ui().fonts.small);
    const ImVec2 corner = ImGui::GetWindowPos();
    float x = corner.x + ImGui::GetWindowContentRegionMax().x - px(6);
    const float y = std::round(ImGui::GetItemRectMin().y);
    for (auto curve = curves.rbegin(); curve != curves.rend(); ++curve) {
        x -= ImGui::CalcTextSize(curve->label).x;
        list.AddText({std::round(x), y}, paint(colors().muted), curve->label);
        x -= px(13);
        list.AddRectFilled({x, y + px(4)}, {x + px(9), y + px(11)}, paint(curve->color), px(2));
        x -= px(12);
    }
}

// Returns the area of the plot in the rest of the panel, with room for the marks of its axes.
Rect plot_area() {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const ImVec2 room = ImGui::GetContentRegionAvail();
    return {at.x + px(44), at.y + px(8), room.x - px(56), room.y - px(32)};
}

// Returns whether there is room and something to draw; otherwise tells that there is not yet.
bool can_draw(const Rect& area, std::size_t rows) {
    if (rows < 2) muted_text("The first points appear after 20 s of the world's time.");
    return rows >= 2 && area.width > px(40) && area.height > px(30);
}

std::vector<double> minutes_of(const std::vector<SeriesRow>& rows) {
    std::vector<double> minutes;
    for (const SeriesRow& row : rows)
        minutes.push_back(static_cast<double>(row.tick) / 3600.0);
    return minutes;
}

std::vector<double> numbers_of(const std::vector<SeriesRow>& rows, Number number) {
    std::vector<double> numbers;
    for (const SeriesRow& row : rows)
        numbers.push_back(number(row));
    return numbers;
}

// Tells the values at the time under the mouse, in the words of a row.
template <class Words>
void tell_values(const PlotScale& scale, const std::vector<SeriesRow>& rows, Words words_of) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    if (!ImGui::IsWindowHovered() || !scale.area.contains(mouse)) return;
    const double minute = scale.x_from(mouse.x);
    const auto at = std::min_element(rows.begin(), rows.end(), [&](const auto& a, const auto& b) {
        return std::fabs(static_cast<double>(a.tick) / 3600.0 - minute) <
               std::fabs(static_cast<double>(b.tick) / 3600.0 - minute);
    });
    const std::string words = world_time(at->tick) + words_of(*at);
    const float x = std::round(scale.x_at(static_cast<double>(at->tick) / 3600.0));
    ImGui::GetWindowDrawList()->AddLine({x, scale.area.y}, {x, scale.area.y + scale.area.height},
                                        paint(colors().faint));
    ImGui::SetTooltip("%s", words.c_str());
}

std::string curve_words(const SeriesRow& row, std::span<const Curve> curves) {
    std::string words;
    for (const Curve& curve : curves)
        words += fmt::format("\n{}: {}", curve.label, pretty_number(curve.number(row)));
    return words;
}

// Example: "plants: 41.2 % (1 250 J)".
std::string pool_words(const SeriesRow& row) {
    double all = 0.0;
    for (const Curve& pool : energy_pools())
        all += pool.number(row);
    std::string words;
    for (const Curve& pool : energy_pools()) {
        const double energy = pool.number(row);
        words += fmt::format("\n{}: {} ({})", pool.label,
                             with_unit(100.0 * energy / std::max(all, 1e-9), "%"),
                             with_unit(energy, "J"));
    }
    return words;
}

}  // namespace

void WorldPlotsPanel::draw(const FrameContext& frame, Requests& out) {
    const auto& plots = world_plots();
    const std::vector<SeriesRow>& rows = *frame.preserve->picture.series;
    place_title("History", "preserve", out);
    ImGui::SameLine(0, px(10));
    std::vector<std::string> titles;
    std::vector<std::string> hints;
    for (const WorldPlot& plot : plots) {
        titles.emplace_back(plot.title);
        hints.push_back(std::string(plot.help) + " (T for the next plot)");
    }
    const auto shown = static_cast<int>(frame.preserve->plot);
    const int pressed = segmented("world plot", titles, shown, hints);
    if (pressed >= 0) out.ask(TurnPlot{pressed - shown});
    const WorldPlot& plot = plots[frame.preserve->plot];
    ImGui::Dummy({0, px(1)});
    caption(plot.help);
    draw_legend(plot.curves);
    const Rect area = plot_area();
    if (!can_draw(area, rows.size())) return;
    const std::vector<double> minutes = minutes_of(rows);
    double most = 0.0;
    for (const Curve& curve : plot.curves) {
        for (const double number : numbers_of(rows, curve.number))
            most = std::max(most, number);
    }
    const PlotRange range = plot_range(0.0, std::max(most, 1e-3));
    const PlotScale scale{area, minutes.front(), minutes.back(), range.low, range.high};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    draw_axes(list, scale, " min");
    for (const Curve& curve : plot.curves)
        draw_curve(list, scale, minutes, numbers_of(rows, curve.number), curve.color, px(1.6F));
    tell_values(scale, rows, [&](const SeriesRow& row) { return curve_words(row, plot.curves); });
}

void EnergyPlotPanel::draw(const FrameContext& frame, Requests& out) {
    const std::vector<SeriesRow>& rows = *frame.preserve->picture.series;
    place_title("Energy", "preserve", out);
    caption(ImGui::GetContentRegionAvail().x < px(kRoomForCaption) ? "%" : "Shares in %");
    draw_legend(energy_pools());
    const Rect area = plot_area();
    if (!can_draw(area, rows.size())) return;
    const std::vector<double> minutes = minutes_of(rows);
    const PlotScale scale{area, minutes.front(), minutes.back(), 0.0, 100.0};
    std::vector<double> all(rows.size(), 0.0);
    for (const Curve& pool : energy_pools()) {
        for (std::size_t i = 0; i < rows.size(); ++i)
            all[i] += pool.number(rows[i]);
    }
    ImDrawList& list = *ImGui::GetWindowDrawList();
    std::vector<double> lower(rows.size(), 0.0);
    for (const Curve& pool : energy_pools()) {
        std::vector<double> upper = lower;
        for (std::size_t i = 0; i < rows.size(); ++i)
            upper[i] += 100.0 * pool.number(rows[i]) / std::max(all[i], 1e-9);
        draw_band(list, scale, minutes, lower, upper, with_alpha(pool.color, 0.8F));
        lower = std::move(upper);
    }
    draw_axes(list, scale, " min");
    tell_values(scale, rows, pool_words);
}

}  // namespace cambrian
