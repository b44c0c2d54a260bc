#pragma once

// One creature in one engine from start to end, either timed or measured.

#include "bench/bench_engine.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace cambrian::bench {

// The two parts of a run whose instructions are counted. They are never inlined, so that a profiler
// can name them.
std::unique_ptr<BenchEngine> build_scene(const EngineKind& kind, const BodyPlan& plan,
                                         const Environment& environment, WorkAudit audit);
void advance_scene(BenchEngine& engine, const BenchCreature& creature, std::size_t first_tick,
                   std::size_t last_tick);

struct Accuracy {
    double greatest_joint_gap = 0.0;       // m, over all ticks
    double energy_residual = 0.0;          // J; change of energy that no recorded work explains
    double greatest_kinetic_energy = 0.0;  // J, over all ticks; reference for the residual
};

Accuracy watch_run(const EngineKind& kind, const BenchCreature& creature,
                   const Environment& environment, std::size_t ticks);

// Returns kinetic and potential energy, in J.
double mechanical_energy(const BodyPlan& plan, const Environment& environment,
                         const std::vector<PartMotion>& parts);
double kinetic_energy(const BodyPlan& plan, double density, const std::vector<PartMotion>& parts);

// Returns the greatest distance, in m, between the two points that a joint connects.
double widest_joint_gap(const BodyPlan& plan, const std::vector<PartMotion>& parts);

}  // namespace cambrian::bench
