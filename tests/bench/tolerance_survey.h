#pragma once

// The error of joint angles and the cost at several tolerances of our physics, for creatures in
// air, in water and on the ground. One tolerance should give similar errors in all of them.

#include "bench/svg_plot.h"

#include <cstddef>
#include <string>
#include <vector>

namespace cambrian::bench {

struct ToleranceSurvey {
    std::vector<std::size_t> bodies = {6, 12};
    std::size_t creatures = 20;  // number of each size; the survey reports medians
    double seconds = 0.5;        // s after which joints are compared with a precise computation
    std::size_t threads = 1;
};

struct SurveyedTolerances {
    std::string csv;
    Plot plot;  // error against tolerance, one curve per workload and size
};

SurveyedTolerances survey_tolerances(const ToleranceSurvey& survey);

}  // namespace cambrian::bench
