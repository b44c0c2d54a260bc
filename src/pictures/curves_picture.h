#pragma once

// Curves with a band around each, on one pair of axes that begin at 0: how several searches went.

#include "pictures/canvas/easel.h"

#include <string>
#include <vector>

namespace cambrian {

struct BandedCurve {
    std::string name;
    // One value of each a point; x ascending.
    std::vector<double> x;
    std::vector<double> lower;
    std::vector<double> middle;
    std::vector<double> upper;
};

struct CurvesLabels {
    std::string title;
    std::string below;  // a line under the title
    std::string x;      // what the axes show, with units
    std::string y;
};

// A curve that has no point is in the legend only.
void draw_curves(Easel& easel, const std::vector<BandedCurve>& curves, const CurvesLabels& labels,
                 const Palette& palette);

}  // namespace cambrian
