#pragma once

// What can be said of a few values that vary a lot.

#include "core/sample_statistics.h"

#include <cstdint>
#include <vector>

namespace cambrian {

struct Interval {
    double low = 0.0;
    double high = 0.0;
};

// 90 % bootstrap interval of the median (percentile method, 10 000 samples from a fixed stream).
Interval median_interval(const std::vector<double>& values);

struct RankTest {
    double p = 1.0;       // that a come out at least so much greater by chance alone
    double effect = 0.5;  // probability that one of a beats one of b; a tie counts half
};

// One-sided Mann-Whitney U test, exact and with midranks for ties: every way to split the values
// into groups of these sizes is counted. Neither may be empty; up to 200 values in all.
RankTest mann_whitney(const std::vector<double>& a, const std::vector<double>& b);
// How likely chance alone puts them at least so far apart, either way round.
double two_sided(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace cambrian
