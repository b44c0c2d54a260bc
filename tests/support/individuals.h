#pragma once

#include "evolution/individual/individual.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace cambrian::test {

// Returns creatures with the given fitness, in that order, each with a different genome and
// phenotype.
inline std::vector<IndividualPtr> individuals(const std::vector<double>& fitness) {
    std::vector<IndividualPtr> all;
    for (std::size_t i = 0; i < fitness.size(); ++i) {
        Genome genome;
        genome.nodes.resize(1);
        genome.nodes[0].length = 0.1 + 0.001 * static_cast<double>(i);
        Individual individual;
        individual.uid = i + 1;
        individual.genome = std::make_shared<const Genome>(genome);
        individual.genome_hash = i;
        individual.evaluated = true;
        individual.result.fitness = fitness[i];
        individual.result.phenotype = i;
        all.push_back(std::make_shared<const Individual>(individual));
    }
    return all;
}

// Returns creatures of the given lines and, if there are any, body plans, best first, with the
// fitness n, n - 1, ..., 1.
inline std::vector<IndividualPtr> ranking(const std::vector<std::uint64_t>& lines,
                                          const std::vector<std::uint64_t>& plans = {}) {
    std::vector<double> fitness;
    for (std::size_t i = 0; i < lines.size(); ++i)
        fitness.push_back(static_cast<double>(lines.size() - i));
    auto all = individuals(fitness);
    for (std::size_t i = 0; i < all.size(); ++i) {
        Individual one = *all[i];
        one.line = lines[i];
        if (!plans.empty()) one.result.plan = plans[i];
        all[i] = std::make_shared<const Individual>(one);
    }
    return all;
}

}  // namespace cambrian::test
