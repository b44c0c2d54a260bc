#pragma once

// Garbage collection of neurons no effector can hear (breeding/README.md 5).

#include "genome/genome.h"

namespace cambrian {

// Removes neurons that no effector hears, directly or through others, in any body the genome could
// grow, and renumbers references so that every other neuron hears the same ones as before. A neuron
// stays where no numbers could achieve that. The compiled brain of a valid genome does not change.
void collect_mute_neurons(Genome& genome);

}  // namespace cambrian
