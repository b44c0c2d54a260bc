#pragma once

// Digests of everything that must have the same bits on every machine, compiler, optimisation level
// and number of threads. What the values are is recorded in digests.txt; everywhere.sh shows that
// they are the same elsewhere.

#include <cstdint>
#include <string>
#include <vector>

namespace cambrian::golden {

struct Digest {
    std::string name;  // no blanks
    std::uint64_t value = 0;
};

using Digests = std::vector<Digest>;

// The elementary functions over grids, random bit patterns and the ends of their domains; and
// random draws.
void add_elementary_digests(Digests& digests);
// Every kind of neuron, fed with ordinary and special values.
void add_neuron_digests(Digests& digests);
// Founders, their bodies, mutants and children by every method.
void add_genome_digests(Digests& digests);
// Random trees in air, water and on the ground by every integrator, and parts that hit each other.
void add_physics_digests(Digests& digests);
// Trials of every goal: motion, energy audit and score.
void add_trial_digests(Digests& digests);
// A small evolution on 1, 2 and 7 threads.
void add_evolution_digests(Digests& digests);

}  // namespace cambrian::golden
