#pragma once

// The median and the quartiles of the runs of an arm, as functions of the number of trials.

#include "comparison/compared_run.h"

#include <vector>

namespace cambrian {

// A curve with one point for each number of trials; lower and upper are quartiles of the runs.
struct CurveBand {
    std::vector<double> trials;
    std::vector<double> lower;
    std::vector<double> middle;
    std::vector<double> upper;
};

// Returns the band at `points` numbers of trials, evenly spaced up to the largest planned number.
// It starts at the first number at which every run had finished a generation. Without runs it is
// empty.
CurveBand band_of(const std::vector<ComparedRun>& runs, int points);

}  // namespace cambrian
