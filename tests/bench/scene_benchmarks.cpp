// Micro-benchmarks of one tick of our scene: workload x bodies. The digest of the motion is printed
// as a counter, so that a faster wrong answer shows.

#include "bench/bench_creature.h"
#include "core/assert.h"
#include "dynamics/planar_scene.h"
#include "support/body_plans.h"
#include "support/workload.h"

#include <benchmark/benchmark.h>

namespace cambrian::bench {
namespace {

constexpr std::size_t kTicks = 600;  // a trial of 10 s, over and over

std::unique_ptr<PhysicsScene> make_scene(const BenchCreature& creature, const Workload& workload) {
    auto scene = planar_scene_kind().make(creature.plan, workload.environment, SceneSettings{});
    CAMBRIAN_ASSERT(scene.has_value(), "benchmark bodies are valid");
    return std::move(scene).value();
}

void advance_tick(PhysicsScene& scene, const BenchCreature& creature, std::size_t tick) {
    for (std::size_t part = 1; part < creature.plan.parts.size(); ++part)
        scene.set_target(part, creature.target(tick, part));
    scene.advance(kTestTick);
}

// Share of 2^32, so that it prints whole.
double short_digest(const PhysicsScene& scene) {
    Hash64 digest;
    scene.add_to_digest(digest);
    return static_cast<double>(digest.value() >> 32U);
}

void advance_scene_tick(benchmark::State& state) {
    const Workload workload = all_workloads()[static_cast<std::size_t>(state.range(0))];
    const auto bodies = static_cast<std::size_t>(state.range(1));
    const BenchCreature creature = random_creature(bodies, 1, kTicks);
    const auto scene = make_scene(creature, workload);
    const auto start = scene->save();
    double digest = 0.0;
    SceneAudit audit;
    std::size_t tick = 0;
    while (state.KeepRunning()) {
        advance_tick(*scene, creature, tick);
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
    // Of the last whole trial, a simulated second; 0 if none was finished.
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
        benchmark::DoNotOptimize(make_scene(creature, workload));
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
