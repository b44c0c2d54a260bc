#include "golden/golden.h"

namespace cambrian::golden {

Digests all_digests() {
    Digests digests;
    add_elementary_digests(digests);
    add_neuron_digests(digests);
    add_genome_digests(digests);
    add_physics_digests(digests);
    add_trial_digests(digests);
    add_evolution_digests(digests);
    return digests;
}

}  // namespace cambrian::golden
