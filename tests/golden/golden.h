#pragma once

// Digests of everything that must have the same bits on every machine, compiler, optimisation level
// and number of threads. digests.txt has the recorded values; everywhere.sh compares them with
// those computed on other processors.

#include <cstdint>
#include <string>
#include <vector>

namespace cambrian::golden {

struct Digest {
    std::string name;  // no blanks
    std::uint64_t value = 0;
};

using Digests = std::vector<Digest>;

// Covers the elementary functions over grids, random bit patterns and the ends of their domains,
// and random draws.
void add_elementary_digests(Digests& digests);
// Covers every neuron function, with ordinary and special values.
void add_neuron_digests(Digests& digests);
// Covers founders, their bodies, mutants, and children by every breeding method; those with organs;
// and founders in space.
void add_genome_digests(Digests& digests);
// Covers random trees in air, water and on the ground with every integrator, and parts that
// collide.
void add_physics_digests(Digests& digests);
// Covers trials of every goal: motion, energy audit and score, and those of swimmers in space; and
// what creatures with organs give off.
void add_trial_digests(Digests& digests);
// Covers a small evolution on 1, 2 and 7 threads, and one of swimmers in space.
void add_evolution_digests(Digests& digests);

Digests all_digests();

}  // namespace cambrian::golden
