#pragma once

// Removal of disconnected neurons, which no effector or organ reads (breeding/README.md 5).

#include "genome/genome.h"

namespace cambrian {

// Removes neurons that no effector or organ reads, directly or through others, in any body that the
// genome may grow. References are renumbered so that all other neurons read the same ones as
// before; a neuron remains if that is impossible. The compiled brain of a valid genome does not
// change.
void remove_disconnected_neurons(Genome& genome);

}  // namespace cambrian
