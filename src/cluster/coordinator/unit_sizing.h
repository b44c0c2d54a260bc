#pragma once

// Estimates the time of evaluations and chooses the size of units. No result depends on it.

#include "evolution/evaluation/evaluation.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace cambrian {

// Measures the time of one evaluation of the accelerations.
class CostModel {
public:
    // Estimated time of each request on one core, s. Requests of unknown work have the median of
    // the others.
    std::vector<double> seconds_of(std::span<const EvaluationRequest> requests) const;
    // Adds a measurement: the total work and time of some creatures.
    void learn(std::size_t creatures, std::uint64_t work, double seconds);

private:
    // Sums in which old measurements have little weight. They start with 3 ms for each creature.
    double creatures_ = 1.0;
    double work_ = 3e3;      // evaluations of the accelerations
    double seconds_ = 3e-3;  // s
};

// Returns after which time a unit that is expected to take so long is late, s.
double unit_deadline(double seconds);

// Cores that share a batch.
struct Cores {
    std::size_t own = 1;
    std::size_t remote = 0;

    std::size_t all() const { return own + remote; }
};

// Estimates the number of useful cores from the work of a batch (s of one core, above 0) and the
// time it took (s).
double useful_cores_of_batch(double core_seconds, double seconds, const Cores& cores);

// The work that is left of a batch, in s of one core.
struct LeftWork {
    double open = 0.0;  // that nobody has
    double sent = 0.0;  // that workers have
    // Time of a unit beyond what the work before it and in it explains, s.
    double latency = 0.0;
    double own_pace = 1.0;  // time of an own core for a second of work
};

// Returns the work of the next unit, in s, at most 2 s; 0 or less if the workers have their share.
// It is a share of the open work, so the last units are short and all cores end at nearly the same
// time (guided self-scheduling, Polychronopoulos and Kuck 1987). It is 10 ms or more, unless the
// workers would then end later than the cores of this machine. If these are busy with much else,
// only the numbers of cores divide the open work.
double unit_seconds(LeftWork left, const Cores& cores);

}  // namespace cambrian
