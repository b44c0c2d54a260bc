#include "evolution/statistics.h"

#include "core/assert.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace cambrian {
namespace {

// Fitness at a share of the way from worst to best; ranked is best first.
double quantile(std::span<const IndividualPtr> ranked, double share) {
    const double position = (1.0 - share) * static_cast<double>(ranked.size() - 1);
    return ranked[static_cast<std::size_t>(std::lround(position))]->result.fitness;
}

}  // namespace

GenerationStatistics summarize(std::span<const IndividualPtr> ranked, std::uint32_t generation,
                               int evaluations) {
    CAMBRIAN_ASSERT(!ranked.empty(), "a generation has creatures");
    GenerationStatistics summary;
    summary.generation = generation;
    summary.size = static_cast<int>(ranked.size());
    summary.evaluations = evaluations;
    summary.best = ranked.front()->result.fitness;
    summary.upper = quantile(ranked, 0.9);
    summary.median = quantile(ranked, 0.5);
    summary.lower = quantile(ranked, 0.1);
    const double count = static_cast<double>(ranked.size());
    std::set<std::uint64_t> hashes;
    for (const IndividualPtr& individual : ranked) {
        const EvaluationResult& result = individual->result;
        summary.mean += result.fitness / count;
        summary.invalid_share += (is_invalid(result.outcome) ? 1.0 : 0.0) / count;
        summary.mean_parts += result.parts / count;
        summary.mean_neurons += result.neurons / count;
        hashes.insert(individual->genome_hash);
    }
    summary.distinct_genomes = static_cast<int>(hashes.size());
    return summary;
}

}  // namespace cambrian
