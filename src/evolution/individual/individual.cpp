#include "evolution/individual/individual.h"

#include <algorithm>
#include <utility>

namespace cambrian {
namespace {

std::size_t gene_count(const Genome& genome) {
    std::size_t count = genome.nodes.size() + genome.brain.size();
    for (const NodeGene& node : genome.nodes)
        count += node.neurons.size();
    return count;
}

}  // namespace

double unconfirmed_score(const EvaluationResult& result) {
    return result.scores.empty() ? result.fitness : result.scores.front();
}

IndividualPtr without_score(const Individual& individual) {
    Individual unscored = individual;
    unscored.evaluated = false;
    unscored.result = {};
    return std::make_shared<const Individual>(std::move(unscored));
}

bool disqualified(const Individual& individual) {
    return is_invalid(individual.result.outcome);
}

bool fitter(const EvaluationResult& a, const EvaluationResult& b) {
    const int a_lacks = shortfall(a.outcome);
    const int b_lacks = shortfall(b.outcome);
    return a_lacks != b_lacks ? a_lacks < b_lacks : a.fitness > b.fitness;
}

std::span<const IndividualPtr> furthest(std::span<const IndividualPtr> ranked) {
    const auto end = std::find_if(ranked.begin(), ranked.end(), [&](const IndividualPtr& one) {
        return shortfall(one->result.outcome) != shortfall(ranked.front()->result.outcome);
    });
    return {ranked.begin(), end};
}

bool better(const Individual& a, const Individual& b) {
    if (fitter(a.result, b.result)) return true;
    if (fitter(b.result, a.result)) return false;
    const std::size_t a_genes = gene_count(*a.genome);
    const std::size_t b_genes = gene_count(*b.genome);
    if (a_genes != b_genes) return a_genes < b_genes;
    if (a.born != b.born) return a.born < b.born;
    return a.uid < b.uid;
}

}  // namespace cambrian
