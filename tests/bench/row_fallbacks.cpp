// cambrian_bench_rows: how often the complementarity solver fails on walkers, so that a problem is
// left to Gauss-Seidel sweeps. Resting contacts and impacts are counted separately.

#include "bench/bench_creature.h"
#include "core/threads/thread_pool.h"
#include "planar/rig.h"
#include "support/workload.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <vector>

namespace cambrian::bench {
namespace {

struct Options {
    std::vector<std::size_t> bodies = {3, 6, 12, 24};
    std::size_t creatures = 40;  // number of creatures of each size
    std::uint64_t first_seed = 1;
    double seconds = 10.0;
    std::size_t threads = ThreadPool::default_workers();
};

Environment walking_ground() {
    for (const Workload& workload : all_workloads()) {
        if (workload.environment.has_ground) return workload.environment;
    }
    return {};
}

// Runs one trial of a walker and returns the solver's counts.
SolverTally tally_of(std::size_t bodies, std::uint64_t seed, double seconds) {
    const auto ticks = static_cast<std::size_t>(seconds / kTestTick);
    const BenchCreature creature = random_creature(bodies, seed, ticks);
    Rig rig(creature.plan, walking_ground());
    rig.begin();
    for (std::size_t tick = 0; tick < ticks; ++tick) {
        for (int part = 0; part < rig.model.part_count; ++part) {
            const int joint = rig.model.part_joint[part];
            if (joint < 0) continue;
            rig.forcing.drive.start[joint] = rig.forcing.drive.end[joint];
            rig.forcing.drive.end[joint] = creature.target(tick, static_cast<std::size_t>(part));
        }
        if (!rig.run(kTestTick)) break;
    }
    return rig.control.solver_tally();
}

double percent(std::uint64_t part, std::uint64_t whole) {
    return whole == 0 ? 0.0 : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

void print_table(const Options& options) {
    std::printf(
        "            resting          |      impacts        |  both\n"
        "bodies  problems/s  given up | problems/s given up | given up\n");
    ThreadPool pool(options.threads);
    for (const std::size_t bodies : options.bodies) {
        std::vector<SolverTally> tallies(options.creatures);
        pool.parallel_for(options.creatures, [&](std::size_t i, std::size_t) {
            tallies[i] = tally_of(bodies, options.first_seed + i, options.seconds);
        });
        SolverTally sum;
        for (const SolverTally& tally : tallies) {
            sum.resting += tally.resting;
            sum.resting_failed += tally.resting_failed;
            sum.impacts += tally.impacts;
            sum.impacts_failed += tally.impacts_failed;
        }
        const double time = options.seconds * static_cast<double>(options.creatures);
        std::printf(
            "%6zu  %10.1f  %6.3f %% | %10.2f %6.3f %% | %6.3f %%\n", bodies,
            static_cast<double>(sum.resting) / time, percent(sum.resting_failed, sum.resting),
            static_cast<double>(sum.impacts) / time, percent(sum.impacts_failed, sum.impacts),
            percent(sum.resting_failed + sum.impacts_failed, sum.resting + sum.impacts));
    }
}

}  // namespace
}  // namespace cambrian::bench

int main(int argc, char** argv) try {
    cambrian::bench::Options options;
    CLI::App app("Complementarity problems of walkers that the solver fails on");
    app.add_option("--bodies", options.bodies, "sizes of the walkers")->check(CLI::Range(1, 32));
    app.add_option("-n,--creatures", options.creatures, "walkers of each size")
        ->check(CLI::PositiveNumber);
    app.add_option("--first-seed", options.first_seed, "seed of the first; the others follow");
    app.add_option("--seconds", options.seconds, "simulated time of each, s")
        ->check(CLI::PositiveNumber);
    app.add_option("--threads", options.threads)->check(CLI::PositiveNumber);
    CLI11_PARSE(app, argc, argv);
    cambrian::bench::print_table(options);
    return EXIT_SUCCESS;
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return EXIT_FAILURE;
}
