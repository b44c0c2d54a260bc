#pragma once

// Random genes within the user's limits, for founders and for new material in mutation
// (genome/README.md 4). All are valid where they are asked for.

#include "core/random.h"
#include "genome/founder_settings.h"
#include "genome/genome.h"
#include "genome/source_rules.h"

#include <cstddef>

namespace cambrian {

// What random genes are drawn from.
struct GenePool {
    const FounderSettings& settings;
    const KindCatalog& catalog;
};

// A constant if the settings allow no kind of reference.
SourceRef random_source(SourceScope scope, const GenePool& pool, RandomStream& stream);
InputGene random_input(SourceScope scope, const GenePool& pool, RandomStream& stream);

// One input of a function, a constant in the function's suggested range if it has one.
InputGene random_function_input(std::size_t function, std::size_t input, SourceScope scope,
                                const GenePool& pool, RandomStream& stream);
NeuronGene random_neuron(SourceScope scope, const GenePool& pool, RandomStream& stream);

// A new source of a node's effector: with the probability, if the node has neurons, one of them.
SourceRef random_effector_source(const NodeGene& node, double local_neuron_share,
                                 const GenePool& pool, RandomStream& stream);

std::uint8_t random_joint(const GenePool& pool, RandomStream& stream);
// Index of an effector; draws nothing where there is only one.
std::uint8_t random_effector_kind(const KindCatalog& catalog, RandomStream& stream);
// Without edges, with a new uid.
NodeGene random_node(const GenePool& pool, RandomStream& stream);
EdgeGene random_edge(std::size_t target, const GenePool& pool, RandomStream& stream);

}  // namespace cambrian
