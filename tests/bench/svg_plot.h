#pragma once

// Plots curves on two logarithmic axes as SVG text.

#include <string>
#include <vector>

namespace cambrian::bench {

struct PlotPoint {
    double x = 1.0;  // above 0
    double y = 1.0;  // above 0
};

struct PlotSeries {
    std::string label;
    std::vector<PlotPoint> points;
};

struct Plot {
    std::string title;
    std::string x_label;
    std::string y_label;
    std::vector<PlotSeries> series;  // colours and markers distinguish up to 45
};

std::string to_svg(const Plot& plot);

}  // namespace cambrian::bench
