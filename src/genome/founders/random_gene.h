#pragma once

// Random genes within the settings' limits, for founders and for mutation (genome/README.md 4). All
// are valid in the scope they are requested for.

#include "core/random.h"
#include "genome/founder_settings.h"
#include "genome/genome.h"
#include "genome/source_rules.h"

#include <cstddef>

namespace cambrian {

// The settings and kinds from which random genes are drawn.
struct GenePool {
    const FounderSettings& settings;
    const KindCatalog& catalog;
};

// Returns a constant if the settings allow no kind of reference.
SourceRef random_source(SourceScope scope, const GenePool& pool, RandomStream& stream);
InputGene random_input(SourceScope scope, const GenePool& pool, RandomStream& stream);

// Returns one input of a function. It is a constant in the function's suggested range if there is
// one.
InputGene random_function_input(std::size_t function, std::size_t input, SourceScope scope,
                                const GenePool& pool, RandomStream& stream);
NeuronGene random_neuron(SourceScope scope, const GenePool& pool, RandomStream& stream);

// Returns a new source for a node's effector. If the node has neurons, the source is one of them
// with the given probability.
SourceRef random_effector_source(const NodeGene& node, double local_neuron_share,
                                 const GenePool& pool, RandomStream& stream);

std::uint8_t random_joint(const GenePool& pool, RandomStream& stream);
// Returns the index of an effector kind. Draws no random number if there is only one.
std::uint8_t random_effector_kind(const KindCatalog& catalog, RandomStream& stream);
// Returns an organ of that kind with random parameters, source and weight.
OrganGene random_organ(std::uint8_t kind, const NodeGene& node, const GenePool& pool,
                       RandomStream& stream);
// Returns a node without edges and with a new uid.
NodeGene random_node(const GenePool& pool, RandomStream& stream);
EdgeGene random_edge(std::size_t target, const GenePool& pool, RandomStream& stream);

}  // namespace cambrian
