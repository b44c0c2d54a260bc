#pragma once

// Small charts: scales, marks and curves. Positions are in window pixels.

#include "studio/look/ui_context.h"

#include <span>
#include <string>
#include <vector>

namespace cambrian {

// Maps data to pixels inside an area; y grows upwards in data and downwards in pixels.
struct PlotScale {
    Rect area;
    double x_low = 0.0;
    double x_high = 1.0;
    double y_low = 0.0;
    double y_high = 1.0;

    float x_at(double x) const;
    float y_at(double y) const;
    double x_from(float pixel) const;
};

// Returns at most `most` round values inside [low, high], in steps of 1, 2 or 5 times a power of
// ten.
std::vector<double> round_marks(double low, double high, int most);

// The range of an axis. plot_range() widens [low, high] so that the two differ and there is some
// room at the top.
struct PlotRange {
    double low = 0.0;
    double high = 1.0;
};
PlotRange plot_range(double low, double high);

// Returns the points that a curve needs at this size: of all points in a pixel column, the first,
// the lowest, the highest and the last. `xs` must not decrease.
std::vector<std::size_t> thinned(const PlotScale& scale, std::span<const double> xs,
                                 std::span<const double> ys);
// The extent of a band in one pixel column that has points.
struct BandColumn {
    double x = 0.0;
    double lower = 0.0;
    double upper = 0.0;
};
std::vector<BandColumn> band_columns(const PlotScale& scale, std::span<const double> xs,
                                     std::span<const double> lower, std::span<const double> upper);

// Draws a curve. The cost grows with the pixels covered, not with the number of points.
void draw_curve(ImDrawList& list, const PlotScale& scale, std::span<const double> xs,
                std::span<const double> ys, const Color& color, float width);
// Draws the area between two curves, at the same cost.
void draw_band(ImDrawList& list, const PlotScale& scale, std::span<const double> xs,
               std::span<const double> lower, std::span<const double> upper, const Color& color);
// Draws horizontal lines with values at the left, and values along the bottom, each followed by a
// unit such as " s".
void draw_axes(ImDrawList& list, const PlotScale& scale, const std::string& x_unit = "");

}  // namespace cambrian
