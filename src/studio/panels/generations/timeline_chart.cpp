#include "studio/panels/generations/timeline_chart.h"

#include "core/text/pretty_text.h"
#include "core/text/shown_score.h"
#include "pictures/scene/scene_builder.h"
#include "studio/widgets/widgets.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <span>

namespace cambrian {
namespace {

constexpr float kSwatch = 14.0F;     // width of a colour sample in the legend
constexpr float kSwatchGap = 6.0F;   // from the sample to its name
constexpr float kEntryGap = 12.0F;   // from one entry to the next
constexpr double kLeastSpan = 10.0;  // least number of generations on the axis

struct LegendEntry {
    const char* label;
    Color color;
    bool band;
};

constexpr std::size_t kNamedLines = 12;  // founder lines with a colour of their own
// Difference in hue between neighbours, in turns: the golden section.
constexpr double kHueStep = 0.381966;

Color band_color(std::size_t band) {
    if (band == kNamedLines) return with_alpha(colors().muted, 0.35F);
    const double hue = kHueStep * static_cast<double>(band);
    return with_alpha(part_color({}, hue - std::floor(hue)), 0.85F);
}

// Returns the founder lines with the most births in all generations, most first.
std::vector<std::uint64_t> most_fertile(const std::vector<GenerationStatistics>& history) {
    std::map<std::uint64_t, int> totals;
    for (const GenerationStatistics& row : history) {
        for (const LineBirths& line : row.births)
            totals[line.line] += line.births;
    }
    std::vector<LineBirths> order;
    for (const auto& [line, births] : totals)
        order.push_back({line, births});
    put_most_first(order);
    std::vector<std::uint64_t> lines;
    for (std::size_t i = 0; i < std::min(order.size(), kNamedLines); ++i)
        lines.push_back(order[i].line);
    return lines;
}

Color curve_color(std::size_t curve) {
    return curve == 0 ? colors().plot_best : colors().plot_median;
}

std::vector<LegendEntry> legend_of(const TimelinePlot& plot) {
    std::vector<LegendEntry> entries;
    for (std::size_t i = 0; i < plot.curves.size(); ++i)
        entries.push_back({plot.curves[i].label, curve_color(i), false});
    if (plot.lower != nullptr)
        entries.push_back({"10–90 %", with_alpha(colors().plot_median, 0.3F), true});
    return entries;
}

float entry_width(const LegendEntry& entry) {
    return px(kSwatch + kSwatchGap) + ImGui::CalcTextSize(entry.label).x;
}

std::span<const double> rows_of(const std::vector<double>& all, std::size_t first,
                                std::size_t end) {
    return std::span(all).subspan(std::min(first, all.size()),
                                  std::min(end, all.size()) - std::min(first, all.size()));
}

}  // namespace

void TimelineChart::forget() {
    generations_.clear();
    pieces_.clear();
    lower_.clear();
    upper_.clear();
    curves_.assign(plot_->curves.size(), {});
    bands_.clear();
}

// Computes all bands, since a new generation may change their order.
void TimelineChart::stack(const EvolutionSnapshot& snapshot) {
    const std::vector<std::uint64_t> lines = most_fertile(snapshot.history);
    bands_.assign(kNamedLines + 1, {});
    for (const GenerationStatistics& row : snapshot.history) {
        std::array<double, kNamedLines + 1> births = {};
        for (const LineBirths& line : row.births) {
            const auto place = std::find(lines.begin(), lines.end(), line.line);
            births[place == lines.end() ? kNamedLines
                                        : static_cast<std::size_t>(place - lines.begin())] +=
                line.births;
        }
        double edge = 0.0;
        for (std::size_t band = 0; band < bands_.size(); ++band)
            bands_[band].push_back(edge += births[band]);
    }
}

void TimelineChart::gather(const EvolutionSnapshot& snapshot, TimelineQuantity quantity) {
    const bool other = quantity != plot_->quantity || snapshot.experiment != experiment_;
    plot_ = &timeline_plot(quantity);
    experiment_ = snapshot.experiment;
    const bool unknown = curves_.empty() && bands_.empty();
    if (other || unknown || snapshot.history.size() < generations_.size()) forget();
    if (plot_->births_by_line && generations_.size() < snapshot.history.size()) stack(snapshot);
    for (std::size_t i = generations_.size(); i < snapshot.history.size(); ++i) {
        const GenerationStatistics& row = snapshot.history[i];
        generations_.push_back(row.generation);
        const bool of_goal = quantity == TimelineQuantity::kFitness;
        const std::string goal = of_goal ? goal_in(snapshot, row.generation) : std::string();
        if (pieces_.empty() || pieces_.back().goal != goal) pieces_.push_back({goal, i, i});
        pieces_.back().end = i + 1;
        for (std::size_t curve = 0; curve < curves_.size(); ++curve)
            curves_[curve].push_back(plot_->curves[curve].measure(row));
        if (plot_->lower == nullptr) continue;
        lower_.push_back(plot_->lower(row));
        upper_.push_back(plot_->upper(row));
    }
}

PlotScale TimelineChart::scale_of(const PlotScale& scale, const Piece& piece) const {
    double lowest = 0.0;
    double highest = 0.0;
    const auto include = [&](const std::vector<double>& all) {
        const auto values = rows_of(all, piece.first, piece.end);
        const auto [low, high] = std::minmax_element(values.begin(), values.end());
        if (low == values.end()) return;
        lowest = std::min(lowest, *low);
        highest = std::max(highest, *high);
    };
    for (const std::vector<double>& curve : curves_)
        include(curve);
    for (const std::vector<double>& band : bands_)
        include(band);
    include(lower_);
    include(upper_);
    const PlotRange y = plot_range(lowest, highest);
    return {scale.area, scale.x_low, scale.x_high, y.low, y.high};
}

PlotScale TimelineChart::scale_for(const Rect& area) const {
    const double last = std::max(generations_.back(), generations_.front() + kLeastSpan);
    return scale_of({area, generations_.front(), last, 0.0, 1.0}, pieces_.back());
}

PlotScale TimelineChart::scale_at(const PlotScale& scale, std::size_t row) const {
    const auto piece = std::find_if(pieces_.begin(), pieces_.end(),
                                    [row](const Piece& each) { return row < each.end; });
    return piece == pieces_.end() ? scale : scale_of(scale, *piece);
}

void TimelineChart::draw(ImDrawList& list, const PlotScale& scale) const {
    const std::vector<double> ground(bands_.empty() ? 0 : generations_.size(), 0.0);
    for (std::size_t i = 0; i < bands_.size(); ++i)
        draw_band(list, scale, generations_, i == 0 ? ground : bands_[i - 1], bands_[i],
                  band_color(i));
    for (const Piece& piece : pieces_) {
        const PlotScale own = scale_of(scale, piece);
        const auto rows = [&](const std::vector<double>& all) {
            return rows_of(all, piece.first, piece.end);
        };
        if (!lower_.empty()) {
            draw_band(list, own, rows(generations_), rows(lower_), rows(upper_),
                      with_alpha(colors().plot_median, 0.22F));
        }
        for (std::size_t i = curves_.size(); i-- > 0;)
            draw_curve(list, own, rows(generations_), rows(curves_[i]), curve_color(i),
                       px(i == 0 ? 2.0F : 1.5F));
    }
}

void TimelineChart::draw_goals(ImDrawList& list, const PlotScale& scale,
                               const GoalRegistry& goals) const {
    if (pieces_.size() < 2) return;
    const WithFont font(ui().fonts.small);
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        const Piece& piece = pieces_[i];
        const bool last = i + 1 == pieces_.size();
        const float from = scale.x_at(generations_[piece.first]);
        const float to =
            last ? scale.area.x + scale.area.width : scale.x_at(generations_[pieces_[i + 1].first]);
        const GoalKind* goal = goals.find(piece.goal);
        const std::vector<double>& best = curves_.front();
        const double top =
            *std::max_element(best.begin() + static_cast<std::ptrdiff_t>(piece.first),
                              best.begin() + static_cast<std::ptrdiff_t>(piece.end));
        const std::string words =
            fmt::format("{}, up to {}", goal == nullptr ? piece.goal : goal->label,
                        shown_score(top, goal == nullptr ? "" : goal->unit));
        if (i > 0) {
            const float x = std::floor(from) + 0.5F;
            list.AddLine({x, scale.area.y}, {x, scale.area.y + scale.area.height},
                         paint(colors().faint), px(1));
        }
        const float room = to - from - px(12);
        if (room < px(24)) continue;
        const std::string shown = fit_text(words, room);
        const ImVec2 size = ImGui::CalcTextSize(shown.c_str());
        const ImVec2 low = {from + px(2), scale.area.y + scale.area.height - px(21)};
        list.AddRectFilled(low, {low.x + size.x + px(8), low.y + size.y + px(2)},
                           paint(with_alpha(colors().panel, 0.8F)), px(4));
        list.AddText(
            {std::floor(from + px(6)), std::floor(scale.area.y + scale.area.height - px(20))},
            paint(colors().muted), shown.c_str());
    }
}

void TimelineChart::draw_dots(ImDrawList& list, const PlotScale& whole, std::size_t row) const {
    const PlotScale scale = scale_at(whole, row);
    for (std::size_t i = curves_.size(); i-- > 0;) {
        const ImVec2 at = {scale.x_at(generations_[row]), scale.y_at(curves_[i][row])};
        list.AddCircleFilled(at, px(4), paint(curve_color(i)));
        list.AddCircle(at, px(4), paint(colors().panel), 0, px(1));
    }
}

std::size_t TimelineChart::row_at(const PlotScale& scale, float pixel) const {
    const double wanted = scale.x_from(pixel);
    const auto after = std::lower_bound(generations_.begin(), generations_.end(), wanted);
    if (after == generations_.begin()) return 0;
    if (after == generations_.end()) return generations_.size() - 1;
    const auto before = after - 1;
    return static_cast<std::size_t>((*after - wanted < wanted - *before ? after : before) -
                                    generations_.begin());
}

std::string timeline_title(const TimelinePlot& plot, const std::string& unit) {
    const bool of_goal = plot.quantity == TimelineQuantity::kFitness && !unit.empty();
    return of_goal ? fmt::format("{} in {}", plot.name, pretty_unit(unit)) : plot.name;
}

float legend_width(const TimelinePlot& plot) {
    const WithFont font(ui().fonts.small);
    float width = 0.0F;
    for (const LegendEntry& entry : legend_of(plot))
        width += entry_width(entry) + (width > 0.0F ? px(kEntryGap) : 0.0F);
    return width;
}

void draw_legend(ImDrawList& list, const TimelinePlot& plot, const ImVec2& right_top) {
    ImVec2 at = {right_top.x - legend_width(plot), right_top.y};
    const WithFont font(ui().fonts.small);
    const float middle = at.y + 0.5F * ImGui::GetFontSize();
    for (const LegendEntry& entry : legend_of(plot)) {
        const float half = entry.band ? px(5) : px(1.2F);
        list.AddRectFilled({at.x, middle - half}, {at.x + px(kSwatch), middle + half},
                           paint(entry.color), px(1));
        list.AddText(ui().fonts.small, ImGui::GetFontSize(),
                     {std::floor(at.x + px(kSwatch + kSwatchGap)), std::floor(at.y)},
                     paint(colors().muted), entry.label);
        at.x += entry_width(entry) + px(kEntryGap);
    }
}

void draw_change_marks(ImDrawList& list, const PlotScale& scale,
                       const EvolutionSnapshot& snapshot) {
    const float top = scale.area.y;
    const float bottom = top + scale.area.height;
    for (std::size_t i = 1; i < snapshot.journal.size(); ++i) {
        const auto generation = static_cast<double>(snapshot.journal[i].generation);
        if (generation > scale.x_high) continue;
        const float x = std::floor(scale.x_at(generation)) + 0.5F;
        list.AddLine({x, top}, {x, bottom}, paint(with_alpha(colors().accent, 0.45F)));
        list.AddTriangleFilled({x - px(5), top - px(5)}, {x + px(5), top - px(5)}, {x, top + px(3)},
                               paint(colors().accent));
    }
}

void draw_timeline_picture(ImDrawList& list, const Rect& area, const EvolutionSnapshot& snapshot,
                           TimelineQuantity quantity, const GoalRegistry& goals) {
    TimelineChart chart;
    chart.gather(snapshot, quantity);
    const TimelinePlot& plot = timeline_plot(quantity);
    const float margin = px(28);
    list.AddText(ui().fonts.title, ui().fonts.title->FontSize, {area.x + margin, area.y + px(22)},
                 paint(colors().text),
                 timeline_title(plot, goal_unit(snapshot.settings->goal, goals)).c_str());
    draw_legend(list, plot, {area.x + area.width - margin, area.y + px(28)});
    if (chart.empty()) return;
    const PlotScale scale =
        chart.scale_for({area.x + margin + px(40), area.y + px(72),
                         area.width - 2 * margin - px(40), area.height - px(72) - px(64)});
    draw_axes(list, scale);
    draw_change_marks(list, scale, snapshot);
    chart.draw(list, scale);
    chart.draw_goals(list, scale, goals);
    const WithFont font(ui().fonts.small);
    const char* across = "generation";
    list.AddText(ui().fonts.small, ImGui::GetFontSize(),
                 {scale.area.center().x - 0.5F * ImGui::CalcTextSize(across).x,
                  area.y + area.height - px(34)},
                 paint(colors().muted), across);
}

}  // namespace cambrian
