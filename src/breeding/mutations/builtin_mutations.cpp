#include "breeding/mutations/operators.h"

namespace cambrian {

// Within a phase, operators are applied in this order: the graph of parts before the neurons in it.
MutationRegistry builtin_mutations() {
    MutationRegistry mutations;
    add_node_operators(mutations);
    add_input_operators(mutations);
    add_neuron_operators(mutations);
    add_growth_operators(mutations);
    add_edge_operators(mutations);
    add_connection_operators(mutations);
    add_removal_operators(mutations);
    add_organ_growth(mutations);
    add_organ_removal(mutations);
    add_organ_change(mutations);
    add_reflex_growth(mutations);
    return mutations;
}

}  // namespace cambrian
