#pragma once

// Plots curves with a band around each, on axes that begin at 0. Comparisons use it for the course
// of several runs.

#include "pictures/canvas/picture_canvas.h"

#include <string>
#include <vector>

namespace cambrian {

struct BandedCurve {
    std::string name;
    // One value per point in each vector; x ascends.
    std::vector<double> x;
    std::vector<double> lower;
    std::vector<double> middle;
    std::vector<double> upper;
};

struct CurvesLabels {
    std::string title;
    std::string below;  // line below the title
    std::string x;      // names of the axes, with units
    std::string y;
};

// Returns the colour of the curve with that index; from the seventh on colours return.
Color color_of_curve(std::size_t curve);

// Draws the curves. A curve without points appears only in the legend.
void draw_curves(PictureCanvas& canvas, const std::vector<BandedCurve>& curves,
                 const CurvesLabels& labels, const Palette& palette);

}  // namespace cambrian
