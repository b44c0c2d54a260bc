#include "evolution/individual.h"

namespace cambrian {
namespace {

std::size_t gene_count(const Genome& genome) {
    std::size_t count = genome.nodes.size() + genome.brain.size();
    for (const NodeGene& node : genome.nodes)
        count += node.neurons.size();
    return count;
}

}  // namespace

bool better(const Individual& a, const Individual& b) {
    const bool a_invalid = is_invalid(a.result.outcome);
    const bool b_invalid = is_invalid(b.result.outcome);
    if (a_invalid != b_invalid) return b_invalid;
    if (a.result.fitness != b.result.fitness) return a.result.fitness > b.result.fitness;
    const std::size_t a_genes = gene_count(*a.genome);
    const std::size_t b_genes = gene_count(*b.genome);
    if (a_genes != b_genes) return a_genes < b_genes;
    if (a.born != b.born) return a.born < b.born;
    return a.uid < b.uid;
}

}  // namespace cambrian
