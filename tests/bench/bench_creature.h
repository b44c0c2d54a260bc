#pragma once

// Bodies to time: the same ones for every engine, drawn from a seed.

#include "world/body_plan.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace cambrian::bench {

// A body and what its motors are asked for.
struct BenchCreature {
    BodyPlan plan;
    std::vector<double> targets;  // [tick * parts + part], in the units of the part's motor mode

    double target(std::size_t tick, std::size_t part) const {
        return targets[tick * plan.parts.size() + part];
    }
};

// A tree of rectangles joined by rotary joints, one third of them branching off a side, whose
// motors swing their joints between the limits at 0.3 to 2 Hz. It starts just above the ground.
BenchCreature random_creature(std::size_t bodies, std::uint64_t seed, std::size_t ticks);

// A folded chain without friction, limits or springs; its joints are twisted, each by its own
// torque, during the first 0.2 s, and left alone from then on.
BenchCreature passive_chain(std::size_t bodies, std::size_t ticks);

}  // namespace cambrian::bench
