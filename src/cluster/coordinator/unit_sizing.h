#pragma once

// How long evaluations may take and how many make a unit. Decides no result.

#include "evolution/evaluation/evaluation.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace cambrian {

// Learns how long an evaluation of the accelerations takes.
class CostModel {
public:
    // s that each request may take on one core. One of unknown work takes as long as the median of
    // the others.
    std::vector<double> seconds_of(std::span<const EvaluationRequest> requests) const;
    // So many creatures took so much work and time, all together.
    void learn(std::size_t creatures, std::uint64_t work, double seconds);

private:
    // Sums in which what was learnt long ago weighs little. To begin with: 3 ms a creature.
    double creatures_ = 1.0;
    double work_ = 3e3;      // evaluations of the accelerations
    double seconds_ = 3e-3;  // s
};

// Cores that share a batch.
struct Cores {
    std::size_t own = 1;
    std::size_t remote = 0;

    std::size_t all() const { return own + remote; }
};

// s of work for the next unit (guided self-scheduling, Polychronopoulos & Kuck 1987): a share of
// what is left, so that the last units are short and no core ends much later than the others; from
// 10 ms to 2 s.
double unit_seconds(double remaining, const Cores& cores);

}  // namespace cambrian
