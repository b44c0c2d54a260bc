// The time of a simulated second of a trial's scent field.

#include "simulator/surroundings/scent_field.h"

#include <benchmark/benchmark.h>

namespace cambrian::bench {
namespace {

constexpr int kStepsASecond = 10;

void spread_scent(benchmark::State& state) {
    ScentField field({.left = -32.0, .columns = 128, .rows = 64, .wall_bottom = true});
    for (int i = 0; i < 40; ++i)
        field.add({-31.0 + 1.5 * i, 0.7 * i, 0.0}, 1.0);
    while (state.KeepRunning()) {
        for (int step = 0; step < kStepsASecond; ++step) {
            field.add({0.0, 1.0, 0.0}, 0.1);
            field.step();
        }
        benchmark::DoNotOptimize(field.at({0.1, 1.0, 0.0}));
    }
}
BENCHMARK(spread_scent)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace cambrian::bench
