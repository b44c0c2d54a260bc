#pragma once

// Statistics for small samples with a large spread.

#include "core/sample_statistics.h"

#include <cstdint>
#include <vector>

namespace cambrian {

struct Interval {
    double low = 0.0;
    double high = 0.0;
};

// Returns the 90 % bootstrap interval of the median: percentile method, 10 000 samples from a fixed
// random stream.
Interval median_interval(const std::vector<double>& values);

struct RankTest {
    double p = 1.0;       // probability that a exceeds b at least this much by chance alone
    double effect = 0.5;  // probability that a value of a exceeds one of b; a tie counts half
};

// One-sided Mann-Whitney U test, exact, with midranks for ties. It counts every way to split the
// values into groups of these sizes. Neither sample may be empty; together they have at most 200
// values.
RankTest mann_whitney(const std::vector<double>& a, const std::vector<double>& b);
// Returns the probability that chance alone makes the samples differ this much in either direction.
double two_sided(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace cambrian
