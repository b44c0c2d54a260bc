#pragma once

// One creature in one engine from start to end, timed or watched.

#include "bench/bench_engine.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace cambrian::bench {

// The two parts of a run whose instructions are counted; never inlined, so that a profiler can name
// them.
std::unique_ptr<BenchEngine> build_scene(const EngineKind& kind, const BodyPlan& plan,
                                         const Environment& environment, WorkAudit audit);
void advance_scene(BenchEngine& engine, const BenchCreature& creature, std::size_t first_tick,
                   std::size_t last_tick);

struct Accuracy {
    double greatest_joint_gap = 0.0;       // m, over all ticks
    double energy_residual = 0.0;          // J; change of energy that no booked work explains
    double greatest_kinetic_energy = 0.0;  // J, over all ticks; what the residual compares to
};

Accuracy watch_run(const EngineKind& kind, const BenchCreature& creature,
                   const Environment& environment, std::size_t ticks);

// J, kinetic and in gravity.
double mechanical_energy(const BodyPlan& plan, const Environment& environment,
                         const std::vector<PartMotion>& parts);
double kinetic_energy(const BodyPlan& plan, double density, const std::vector<PartMotion>& parts);

// m; the widest distance between the two points a joint should hold together.
double widest_joint_gap(const BodyPlan& plan, const std::vector<PartMotion>& parts);

}  // namespace cambrian::bench
