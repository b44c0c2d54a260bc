#pragma once

// Small charts: scales, marks and curves; positions in window pixels.

#include "studio/look/ui_context.h"

#include <span>
#include <string>
#include <vector>

namespace cambrian {

// Data to pixels inside an area; y grows upwards in data and downwards in pixels.
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

// Round values inside [low, high], at most `most` of them, at steps of 1, 2 or 5 times a power of
// ten.
std::vector<double> round_marks(double low, double high, int most);

// low and high widened so that they differ, with a little air above.
struct Range {
    double low = 0.0;
    double high = 1.0;
};
Range plot_range(double low, double high);

// Which points a curve needs at this size: of the points that share a pixel column, the first, the
// lowest, the highest and the last. xs must not fall.
std::vector<std::size_t> thinned(const PlotScale& scale, std::span<const double> xs,
                                 std::span<const double> ys);
// A band's extent, one entry a pixel column that has points.
struct BandColumn {
    double x = 0.0;
    double lower = 0.0;
    double upper = 0.0;
};
std::vector<BandColumn> band_columns(const PlotScale& scale, std::span<const double> xs,
                                     std::span<const double> lower, std::span<const double> upper);

// Curves and bands of any number of points cost no more than the pixels they cover.
void draw_curve(ImDrawList& list, const PlotScale& scale, std::span<const double> xs,
                std::span<const double> ys, const Color& color, float width);
// The area between two curves.
void draw_band(ImDrawList& list, const PlotScale& scale, std::span<const double> xs,
               std::span<const double> lower, std::span<const double> upper, const Color& color);
// Horizontal lines with values at the left, and values along the bottom.
void draw_axes(ImDrawList& list, const PlotScale& scale);

}  // namespace cambrian
