#pragma once

// What the tolerance of our physics comes to on creatures: the error of their joint angles and the
// cost, in air, in water and on the ground. One number is to mean the same in all of them.

#include "bench/svg_plot.h"

#include <cstddef>
#include <string>
#include <vector>

namespace cambrian::bench {

struct ToleranceSurvey {
    std::vector<std::size_t> bodies = {6, 12};
    std::size_t creatures = 20;  // of each size; medians are told
    double seconds = 0.5;        // after which joints are compared with an exact computation
    std::size_t threads = 1;
};

struct SurveyedTolerances {
    std::string csv;
    Plot plot;  // error against tolerance, a curve a workload and size
};

SurveyedTolerances survey_tolerances(const ToleranceSurvey& survey);

}  // namespace cambrian::bench
