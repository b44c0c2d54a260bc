#include "bench/svg_plot.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

namespace cambrian::bench {
namespace {

constexpr double kWidth = 760, kHeight = 470;  // pixels
constexpr double kLeft = 76, kRight = 520, kTop = 48, kBottom = 410;
constexpr double kLegendX = 544, kLegendStep = 26;

// Okabe & Ito's palette, safe for colour-blind readers. Markers distinguish the curves as well.
constexpr std::array<const char*, 9> kColors = {"#0072B2", "#D55E00", "#009E73",
                                                "#CC79A7", "#56B4E9", "#E69F00",
                                                "#000000", "#8C8C00", "#767676"};

// An axis of decades from `low` to `high` and its position in pixels.
struct Axis {
    int low;
    int high;
    double first_pixel;
    double last_pixel;

    double pixel(double exponent) const {
        return first_pixel + (exponent - low) / (high - low) * (last_pixel - first_pixel);
    }
};

template <class Coordinate>
Axis axis_over(const Plot& plot, Coordinate coordinate, double first_pixel, double last_pixel) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const PlotSeries& series : plot.series) {
        for (const PlotPoint& point : series.points) {
            low = std::fmin(low, std::log10(coordinate(point)));
            high = std::fmax(high, std::log10(coordinate(point)));
        }
    }
    const int first = static_cast<int>(std::floor(low));
    return {first, std::max(first + 1, static_cast<int>(std::ceil(high))), first_pixel, last_pixel};
}

template <class... Values>
std::string format(const char* pattern, Values... values) {
    std::array<char, 512> text{};
    std::snprintf(text.data(), text.size(), pattern, values...);
    return text.data();
}

std::string line(double x1, double y1, double x2, double y2, const char* color) {
    return fmt::format("<line x1='{:.1f}' y1='{:.1f}' x2='{:.1f}' y2='{:.1f}' stroke='{}'/>\n", x1,
                       y1, x2, y2, color);
}

std::string power_of_ten(double x, double y, const char* anchor, int exponent) {
    return format(
        "<text x='%.1f' y='%.1f' text-anchor='%s' fill='#444'>10<tspan dy='-5' font-size='10'>"
        "%d</tspan></text>\n",
        x, y, anchor, exponent);
}

std::string grid(const Axis& x, const Axis& y) {
    std::string svg;
    for (int decade = x.low; decade <= x.high; ++decade) {
        const double at = x.pixel(decade);
        svg += line(at, kTop, at, kBottom, "#e3e3e3");
        svg += power_of_ten(at, kBottom + 20, "middle", decade);
    }
    const int step = y.high - y.low > 8 ? 2 : 1;
    for (int decade = y.low; decade <= y.high; decade += step) {
        const double at = y.pixel(decade);
        svg += line(kLeft, at, kRight, at, "#e3e3e3");
        svg += power_of_ten(kLeft - 10, at + 4, "end", decade);
    }
    svg += line(kLeft, kBottom, kRight, kBottom, "#666");
    svg += line(kLeft, kTop, kLeft, kBottom, "#666");
    return svg;
}

std::string marker(std::size_t index, double x, double y) {
    const char* color = kColors[index % kColors.size()];
    switch (index % 5) {
        case 0:
            return fmt::format("<circle cx='{:.1f}' cy='{:.1f}' r='4' fill='{}'/>\n", x, y, color);
        case 1:
            return fmt::format("<rect x='{:.1f}' y='{:.1f}' width='7' height='7' fill='{}'/>\n",
                               x - 3.5, y - 3.5, color);
        case 2:
            return fmt::format("<path d='M{:.1f} {:.1f}l4.5 8h-9z' fill='{}'/>\n", x, y - 5, color);
        case 3:
            return fmt::format("<path d='M{:.1f} {:.1f}l4.8 4.8l-4.8 4.8l-4.8-4.8z' fill='{}'/>\n",
                               x, y - 4.8, color);
        default:
            return format(
                "<circle cx='%.1f' cy='%.1f' r='3.4' fill='#fff' stroke='%s' stroke-width='2'/>\n",
                x, y, color);
    }
}

std::string curve(const PlotSeries& series, std::size_t index, const Axis& x, const Axis& y) {
    std::string path;
    std::string markers;
    for (const PlotPoint& point : series.points) {
        const double at_x = x.pixel(std::log10(point.x));
        const double at_y = y.pixel(std::log10(point.y));
        path += fmt::format("{:.1f},{:.1f} ", at_x, at_y);
        markers += marker(index, at_x, at_y);
    }
    return fmt::format("<polyline fill='none' stroke-width='1.6' stroke='{}' points='",
                       kColors[index % kColors.size()]) +
           path + "'/>\n" + markers;
}

std::string legend(const Plot& plot) {
    std::string svg;
    for (std::size_t i = 0; i < plot.series.size(); ++i) {
        const double y = kTop + 12 + kLegendStep * static_cast<double>(i);
        svg += line(kLegendX, y, kLegendX + 24, y, kColors[i % kColors.size()]);
        svg += marker(i, kLegendX + 12, y);
        svg += fmt::format("<text x='{:.1f}' y='{:.1f}' fill='#222'>{}</text>\n", kLegendX + 32,
                           y + 4, plot.series[i].label.c_str());
    }
    return svg;
}

std::string titles(const Plot& plot) {
    const double middle_x = 0.5 * (kLeft + kRight);
    const double middle_y = 0.5 * (kTop + kBottom);
    return fmt::format("<text x='{:.1f}' y='26' font-size='15' fill='#111'>{}</text>\n", kLeft,
                       plot.title.c_str()) +
           fmt::format("<text x='{:.1f}' y='{:.1f}' text-anchor='middle' fill='#222'>{}</text>\n",
                       middle_x, kBottom + 46, plot.x_label.c_str()) +
           format(
               "<text transform='translate(20 %.1f) rotate(-90)' text-anchor='middle' "
               "fill='#222'>%s</text>\n",
               middle_y, plot.y_label.c_str());
}

}  // namespace

std::string to_svg(const Plot& plot) {
    const Axis x = axis_over(
        plot, [](const PlotPoint& p) { return p.x; }, kLeft, kRight);
    const Axis y = axis_over(
        plot, [](const PlotPoint& p) { return p.y; }, kBottom, kTop);
    std::string svg = format(
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 %.0f %.0f' "
        "font-family='Inter, sans-serif' font-size='12.5'>\n"
        "<rect width='100%%' height='100%%' fill='#fff'/>\n",
        kWidth, kHeight);
    svg += grid(x, y) + titles(plot);
    for (std::size_t i = 0; i < plot.series.size(); ++i)
        svg += curve(plot.series[i], i, x, y);
    return svg + legend(plot) + "</svg>\n";
}

}  // namespace cambrian::bench
