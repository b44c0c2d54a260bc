#pragma once

// Registers the mutation operators of breeding/README.md 3, grouped by the genes they change.

#include "breeding/mutation_kind.h"
#include "genome/founders/random_gene.h"

namespace cambrian {

void add_node_operators(MutationRegistry& mutations);        // node-scalar, node-discrete, root
void add_input_operators(MutationRegistry& mutations);       // effector, weight, source
void add_neuron_operators(MutationRegistry& mutations);      // function
void add_growth_operators(MutationRegistry& mutations);      // add-node, add-neuron
void add_edge_operators(MutationRegistry& mutations);        // edge-scalar, edge-flag, retarget
void add_connection_operators(MutationRegistry& mutations);  // add-edge, remove-edge
void add_removal_operators(MutationRegistry& mutations);     // remove-neuron

inline GenePool pool_of(const MutationContext& context) {
    return {context.founders, context.catalog};
}

}  // namespace cambrian
