#pragma once

// Bodies for the benchmarks, drawn from a seed so that every engine gets the same ones.

#include "world/body_plan.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace cambrian::bench {

// A body and the targets of its motors.
struct BenchCreature {
    BodyPlan plan;
    std::vector<double> targets;  // [tick * parts + part], in the unit of the part's motor mode

    double target(std::size_t tick, std::size_t part) const {
        return targets[tick * plan.parts.size() + part];
    }
};

// Returns a tree of rectangles with rotary joints, one third of which are attached to a side. The
// motors swing the joints between their limits at 0.3 to 2 Hz. It starts just above the ground.
BenchCreature random_creature(std::size_t bodies, std::uint64_t seed, std::size_t ticks);

// Returns a folded chain without friction, limits or springs. Each joint is driven by a different
// torque during the first 0.2 s and by none afterwards.
BenchCreature passive_chain(std::size_t bodies, std::size_t ticks);

}  // namespace cambrian::bench
