#pragma once

// How runs of an arm went: their middle and how far they lie apart, along the trials.

#include "comparison/compared_run.h"

#include <vector>

namespace cambrian {

// One point for each number of trials; scores are quartiles of the runs.
struct CurveBand {
    std::vector<double> trials;
    std::vector<double> lower;
    std::vector<double> middle;
    std::vector<double> upper;
};

// At so many numbers of trials, evenly up to the most that any planned; from the first at which
// every run had finished a generation. Empty without runs.
CurveBand band_of(const std::vector<ComparedRun>& runs, int points);

}  // namespace cambrian
