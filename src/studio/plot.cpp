#include "studio/plot.h"

#include "studio/text.h"

#include <algorithm>
#include <cmath>

namespace cambrian {

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

Range plot_range(double low, double high) {
    if (!(high > low)) {
        const double size = std::fmax(1.0, std::fabs(low));
        return {low, low + size};
    }
    return {low, high + 0.08 * (high - low)};
}

void draw_curve(ImDrawList& list, const PlotScale& scale, std::span<const double> xs,
                std::span<const double> ys, const Color& color, float width) {
    std::vector<ImVec2> points;
    points.reserve(xs.size());
    for (std::size_t i = 0; i < xs.size(); ++i)
        points.emplace_back(scale.x_at(xs[i]), scale.y_at(ys[i]));
    if (points.size() == 1) {
        list.AddCircleFilled(points.front(), 1.5F * width, paint(color));
        return;
    }
    list.AddPolyline(points.data(), static_cast<int>(points.size()), paint(color), ImDrawFlags_None,
                     width);
}

void draw_band(ImDrawList& list, const PlotScale& scale, std::span<const double> xs,
               std::span<const double> lower, std::span<const double> upper, const Color& color) {
    // Without anti-aliasing, neighbouring quads meet without a seam.
    const ImDrawListFlags flags = list.Flags;
    list.Flags &= ~ImDrawListFlags_AntiAliasedFill;
    for (std::size_t i = 0; i + 1 < xs.size(); ++i) {
        const float left = scale.x_at(xs[i]);
        const float right = scale.x_at(xs[i + 1]);
        list.AddQuadFilled({left, scale.y_at(upper[i])}, {right, scale.y_at(upper[i + 1])},
                           {right, scale.y_at(lower[i + 1])}, {left, scale.y_at(lower[i])},
                           paint(color));
    }
    list.Flags = flags;
}

void draw_axes(ImDrawList& list, const PlotScale& scale) {
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
        const std::string label = pretty_number(value);
        const ImVec2 size = ImGui::CalcTextSize(label.c_str());
        list.AddText({scale.x_at(value) - 0.5F * size.x, scale.area.y + scale.area.height + px(4)},
                     text, label.c_str());
    }
}

}  // namespace cambrian
