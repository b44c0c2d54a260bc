#pragma once

// The options of benchmarks that time the same creatures in several engines and worlds.

#include "support/body_plans.h"

#include <CLI/CLI.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace cambrian::bench {

struct CellOptions {
    std::vector<std::string> engines;    // ids; all if empty
    std::vector<std::string> workloads;  // ids; all if empty
    std::vector<std::size_t> bodies = {3, 6, 12, 24};
    std::size_t creatures = 10;
    std::size_t rounds = 3;
    double seconds = 10.0;
    std::uint64_t seed = 1;
    bool advance_only = false;

    std::size_t ticks() const { return static_cast<std::size_t>(std::lround(seconds / kTestTick)); }
};

// `engines` names the choices.
inline void add_cell_options(CLI::App& app, CellOptions& options, const std::string& engines) {
    app.add_option("--engine", options.engines, engines + "; all by default");
    app.add_option("--workload", options.workloads, "air, swim, walk; all by default");
    app.add_option("--bodies", options.bodies, "bodies a creature");
    app.add_option("--creatures", options.creatures, "creatures a cell")
        ->check(CLI::PositiveNumber);
    app.add_option("--rounds", options.rounds, "rounds; medians are printed")
        ->check(CLI::PositiveNumber);
    app.add_option("--seconds", options.seconds, "simulated time of a run, s")
        ->check(CLI::PositiveNumber);
    app.add_option("--seed", options.seed, "of the creatures");
    app.add_flag("--advance-only", options.advance_only, "run once and measure nothing");
}

}  // namespace cambrian::bench
