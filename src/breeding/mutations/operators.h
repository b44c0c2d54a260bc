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
void add_organ_growth(MutationRegistry& mutations);          // add-organ
void add_organ_removal(MutationRegistry& mutations);         // remove-organ
void add_organ_change(MutationRegistry& mutations);          // organ
void add_reflex_growth(MutationRegistry& mutations);         // add-reflex

// Whether any kind of organ is enabled.
bool organs_enabled(const MutationContext& context);

// Replaces the source of a link; adds the word "source" to the record's place.
void replace_source(InputGene& input, const SourceRef& source, const KindCatalog& catalog,
                    MutationRecord& record);

inline GenePool pool_of(const MutationContext& context) {
    return {context.founders, context.catalog};
}

}  // namespace cambrian
