// Micro-benchmarks of one tick of our scene: workload x bodies. A counter shows the digest of the
// motion, which reveals a faster but wrong result.

#include "bench/planar_runs.h"
#include "support/body_plans.h"
#include "support/workload.h"

#include <benchmark/benchmark.h>

namespace cambrian::bench {
namespace {

constexpr std::size_t kTicks = 600;  // a trial of 10 s, which is repeated

// Returns 32 bits of the digest, which a double represents exactly.
double short_digest(const PhysicsScene& scene) {
    Hash64 digest;
    scene.add_to_digest(digest);
    return static_cast<double>(digest.value() >> 32U);
}

void advance_scene_tick(benchmark::State& state) {
    const Workload workload = all_workloads()[static_cast<std::size_t>(state.range(0))];
    const auto bodies = static_cast<std::size_t>(state.range(1));
    const BenchCreature creature = random_creature(bodies, 1, kTicks);
    const auto scene = make_planar_scene(creature.plan, workload.environment);
    const auto start = scene->save();
    double digest = 0.0;
    SceneAudit audit;
    std::size_t tick = 0;
    while (state.KeepRunning()) {
        advance_planar_scene(*scene, creature, tick);
        if (++tick < kTicks) continue;
        state.PauseTiming();
        digest = short_digest(*scene);
        audit = scene->audit();
        scene->restore(*start);
        tick = 0;
        state.ResumeTiming();
    }
    state.SetLabel(workload.id);
    state.counters["digest"] = digest;
    // Rates per simulated second of the last finished trial; 0 if there is none.
    const double seconds = static_cast<double>(kTicks) * kTestTick;
    state.counters["evaluations"] = static_cast<double>(audit.evaluations) / seconds;
    state.counters["steps"] = static_cast<double>(audit.steps) / seconds;
    state.counters["rejections"] = static_cast<double>(audit.rejections) / seconds;
    state.counters["events"] = static_cast<double>(audit.events) / seconds;
    state.counters["fallbacks"] = static_cast<double>(audit.fallbacks) / seconds;
}
BENCHMARK(advance_scene_tick)
    ->ArgNames({"workload", "bodies"})
    ->ArgsProduct({{0, 1, 2}, {3, 6, 12, 24}})
    ->Unit(benchmark::kMicrosecond);

void build_scene(benchmark::State& state) {
    const Workload workload = all_workloads().back();
    const BenchCreature creature = random_creature(static_cast<std::size_t>(state.range(0)), 1, 1);
    while (state.KeepRunning())
        benchmark::DoNotOptimize(make_planar_scene(creature.plan, workload.environment));
}
BENCHMARK(build_scene)
    ->ArgName("bodies")
    ->Arg(3)
    ->Arg(6)
    ->Arg(12)
    ->Arg(24)
    ->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace cambrian::bench
