#include "studio/widgets/plot.h"

#include "core/text/pretty_text.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace cambrian {
namespace {

// Returns one past the last point in the pixel column of the point at `begin`.
std::size_t end_of_column(const PlotScale& scale, std::span<const double> xs, std::size_t begin) {
    const float column = std::floor(scale.x_at(xs[begin]));
    std::size_t end = begin + 1;
    while (end < xs.size() && std::floor(scale.x_at(xs[end])) == column)
        ++end;
    return end;
}

}  // namespace

float PlotScale::x_at(double x) const {
    return area.x + area.width * static_cast<float>((x - x_low) / (x_high - x_low));
}

float PlotScale::y_at(double y) const {
    return area.y + area.height * static_cast<float>((y_high - y) / (y_high - y_low));
}

double PlotScale::x_from(float pixel) const {
    return x_low + (x_high - x_low) * static_cast<double>((pixel - area.x) / area.width);
}

std::vector<double> round_marks(double low, double high, int most) {
    std::vector<double> marks;
    if (!(high > low) || most < 1) return marks;
    const double least = (high - low) / most;
    const double decade = std::pow(10.0, std::floor(std::log10(least)));
    double step = 10.0 * decade;
    for (const double factor : {5.0, 2.0, 1.0}) {
        if (factor * decade >= least) step = factor * decade;
    }
    const double slack = 1e-9 * step;
    for (double i = std::ceil((low - slack) / step); i * step <= high + slack; i += 1.0) {
        marks.push_back(i * step);
    }
    return marks;
}

PlotRange plot_range(double low, double high) {
    if (!(high > low)) {
        const double size = std::fmax(1.0, std::fabs(low));
        return {low, low + size};
    }
    return {low, high + 0.08 * (high - low)};
}

std::vector<std::size_t> thinned(const PlotScale& scale, std::span<const double> xs,
                                 std::span<const double> ys) {
    std::vector<std::size_t> kept;
    for (std::size_t begin = 0; begin < xs.size();) {
        const std::size_t end = end_of_column(scale, xs, begin);
        std::array<std::size_t, 4> corners = {begin, begin, begin, end - 1};
        for (std::size_t i = begin; i < end; ++i) {
            if (ys[i] < ys[corners[1]]) corners[1] = i;
            if (ys[i] > ys[corners[2]]) corners[2] = i;
        }
        std::sort(corners.begin(), corners.end());
        kept.insert(kept.end(), corners.begin(), std::unique(corners.begin(), corners.end()));
        begin = end;
    }
    return kept;
}

std::vector<BandColumn> band_columns(const PlotScale& scale, std::span<const double> xs,
                                     std::span<const double> lower, std::span<const double> upper) {
    std::vector<BandColumn> columns;
    for (std::size_t begin = 0; begin < xs.size();) {
        const std::size_t end = end_of_column(scale, xs, begin);
        BandColumn column{xs[begin], lower[begin], upper[begin]};
        for (std::size_t i = begin; i < end; ++i) {
            column.lower = std::min(column.lower, lower[i]);
            column.upper = std::max(column.upper, upper[i]);
        }
        columns.push_back(column);
        begin = end;
    }
    return columns;
}

void draw_curve(ImDrawList& list, const PlotScale& scale, std::span<const double> xs,
                std::span<const double> ys, const Color& color, float width) {
    std::vector<ImVec2> points;
    for (const std::size_t i : thinned(scale, xs, ys))
        points.emplace_back(scale.x_at(xs[i]), scale.y_at(ys[i]));
    if (points.size() == 1) {
        list.AddCircleFilled(points.front(), 1.5F * width, paint(color));
        return;
    }
    // Draws each segment separately, since a joined line becomes thin at sharp turns.
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        list.PathLineTo(points[i]);
        list.PathLineTo(points[i + 1]);
        list.PathStroke(paint(color), ImDrawFlags_None, width);
    }
}

void draw_band(ImDrawList& list, const PlotScale& scale, std::span<const double> xs,
               std::span<const double> lower, std::span<const double> upper, const Color& color) {
    const std::vector<BandColumn> columns = band_columns(scale, xs, lower, upper);
    // Without anti-aliasing, neighbouring quads meet without a gap.
    const ImDrawListFlags flags = list.Flags;
    list.Flags &= ~ImDrawListFlags_AntiAliasedFill;
    for (std::size_t i = 0; i + 1 < columns.size(); ++i) {
        const BandColumn& from = columns[i];
        const BandColumn& to = columns[i + 1];
        const float left = scale.x_at(from.x);
        const float right = scale.x_at(to.x);
        list.AddQuadFilled({left, scale.y_at(from.upper)}, {right, scale.y_at(to.upper)},
                           {right, scale.y_at(to.lower)}, {left, scale.y_at(from.lower)},
                           paint(color));
    }
    list.Flags = flags;
}

void draw_axes(ImDrawList& list, const PlotScale& scale, const std::string& x_unit) {
    const WithFont font(ui().fonts.small);
    const ImU32 line = paint(with_alpha(colors().border, 0.7F));
    const ImU32 text = paint(colors().muted);
    const int rows = std::max(2, static_cast<int>(scale.area.height / px(34)));
    for (const double value : round_marks(scale.y_low, scale.y_high, rows)) {
        const float y = std::floor(scale.y_at(value)) + 0.5F;
        list.AddLine({scale.area.x, y}, {scale.area.x + scale.area.width, y}, line);
        const std::string label = pretty_number(value);
        const ImVec2 size = ImGui::CalcTextSize(label.c_str());
        list.AddText({scale.area.x - size.x - px(8), y - 0.5F * size.y}, text, label.c_str());
    }
    const int columns = std::max(1, static_cast<int>(scale.area.width / px(80)));
    for (const double value : round_marks(scale.x_low, scale.x_high, columns)) {
        if (value != std::floor(value)) continue;
        const std::string label = pretty_number(value) + x_unit;
        const ImVec2 size = ImGui::CalcTextSize(label.c_str());
        list.AddText({scale.x_at(value) - 0.5F * size.x, scale.area.y + scale.area.height + px(4)},
                     text, label.c_str());
    }
}

}  // namespace cambrian
