#pragma once

#include "evolution/individual.h"

#include <cstdint>
#include <span>
#include <vector>

namespace cambrian {

// What is plotted and printed of one evaluated generation.
struct GenerationStatistics {
    std::uint32_t generation = 0;
    int size = 0;
    int evaluations = 0;  // distinct trials run for it
    double best = 0.0;    // fitness
    double upper = 0.0;   // 90th percentile
    double median = 0.0;
    double lower = 0.0;  // 10th percentile
    double mean = 0.0;
    double invalid_share = 0.0;  // diverged or cheated
    double mean_parts = 0.0;
    double mean_neurons = 0.0;
    int distinct_genomes = 0;
};

// ranked: best first.
GenerationStatistics summarize(std::span<const IndividualPtr> ranked, std::uint32_t generation,
                               int evaluations);

}  // namespace cambrian
