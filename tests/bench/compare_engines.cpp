// cambrian_bench_engines: runs the same creatures in every engine, interleaved on one thread.
// Prints CPU time per simulated second, the ratio of each engine's time to ours, and its accuracy.

#include "bench/cell_options.h"
#include "bench/engine_kinds.h"
#include "bench/runs.h"
#include "bench/selection.h"
#include "bench/write_table.h"
#include "core/sample_statistics.h"
#include "core/thread_time.h"
#include "support/body_plans.h"
#include "support/workload.h"

#include <CLI/CLI.hpp>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <limits>
#include <string>

namespace cambrian::bench {
namespace {

struct Options : CellOptions {
    std::string csv_path;
};

// The figures of one engine for one workload and number of bodies.
struct Cell {
    double micros = 0.0;        // CPU time of a creature's simulated second, in microseconds
    double build_micros = 0.0;  // CPU time of building a creature, in microseconds
    double ratio = 1.0;         // `micros` relative to the first engine
    double joint_gap = 0.0;     // m, widest of all creatures and ticks
    double residual = 0.0;      // J, mean of the absolute values
    double kinetic = 0.0;       // J, mean of the creatures' greatest kinetic energies
};

std::vector<BenchCreature> draw_creatures(const Options& options, std::size_t bodies) {
    std::vector<BenchCreature> creatures;
    for (std::size_t i = 0; i < options.creatures; ++i)
        creatures.push_back(random_creature(bodies, options.seed + i, options.ticks()));
    return creatures;
}

// CPU seconds of one round, indexed by engine.
struct RoundTimes {
    std::vector<double> build;
    std::vector<double> advance;
};

// Runs every creature in every engine. The engine that goes first alternates between creatures.
RoundTimes time_round(const std::vector<EngineKind>& engines,
                      const std::vector<BenchCreature>& creatures, const Environment& environment,
                      std::size_t ticks) {
    RoundTimes times{std::vector<double>(engines.size()), std::vector<double>(engines.size())};
    for (std::size_t c = 0; c < creatures.size(); ++c) {
        for (std::size_t turn = 0; turn < engines.size(); ++turn) {
            const std::size_t e = (c + turn) % engines.size();
            const double start = thread_cpu_time();
            const auto scene =
                build_scene(engines[e], creatures[c].plan, environment, WorkAudit::kOff);
            const double built = thread_cpu_time();
            advance_scene(*scene, creatures[c], 0, ticks);
            times.build[e] += built - start;
            times.advance[e] += thread_cpu_time() - built;
        }
    }
    return times;
}

void measure_time(const Options& options, const std::vector<EngineKind>& engines,
                  const std::vector<BenchCreature>& creatures, const Environment& environment,
                  std::vector<Cell>& cells) {
    std::vector<std::vector<double>> micros(engines.size()), build(engines.size()),
        ratios(engines.size());
    const auto count = static_cast<double>(creatures.size());
    for (std::size_t round = 0; round < options.rounds; ++round) {
        const RoundTimes times = time_round(engines, creatures, environment, options.ticks());
        for (std::size_t e = 0; e < engines.size(); ++e) {
            constexpr double micro = 1e6;
            micros[e].push_back(micro * times.advance[e] / (count * options.seconds));
            build[e].push_back(micro * times.build[e] / count);
            ratios[e].push_back(times.advance[e] / times.advance[0]);
        }
    }
    for (std::size_t e = 0; e < engines.size(); ++e) {
        cells[e].micros = median(micros[e]);
        cells[e].build_micros = median(build[e]);
        cells[e].ratio = median(ratios[e]);
    }
}

void measure_accuracy(const Options& options, const std::vector<EngineKind>& engines,
                      const std::vector<BenchCreature>& creatures, const Workload& workload,
                      std::vector<Cell>& cells) {
    const auto count = static_cast<double>(creatures.size());
    for (std::size_t e = 0; e < engines.size(); ++e) {
        for (const BenchCreature& creature : creatures) {
            const Accuracy accuracy =
                watch_run(engines[e], creature, workload.environment, options.ticks());
            cells[e].joint_gap = std::fmax(cells[e].joint_gap, accuracy.greatest_joint_gap);
            cells[e].residual += std::fabs(accuracy.energy_residual) / count;
            cells[e].kinetic += accuracy.greatest_kinetic_energy / count;
        }
        // Without the work of contacts, impacts with the ground would dominate the residual.
        if (!engines[e].audits_contacts && workload.environment.has_ground)
            cells[e].residual = std::numeric_limits<double>::quiet_NaN();
    }
}

void print_heading() {
    std::printf("%-8s %6s  %-16s %10s %7s %9s %11s %11s %9s\n", "workload", "bodies", "engine",
                "us/s", "ratio", "build us", "gap m", "residual J", "kinetic J");
}

void print_cell(const Workload& workload, std::size_t bodies, const EngineKind& engine,
                const Cell& cell) {
    std::printf("%-8s %6zu  %-16s %10.1f %7.2f %9.1f %11.2e %11.2e %9.2f\n", workload.id.c_str(),
                bodies, engine.id.c_str(), cell.micros, cell.ratio, cell.build_micros,
                cell.joint_gap, cell.residual, cell.kinetic);
}

void append_row(std::string& csv, const Workload& workload, std::size_t bodies,
                const EngineKind& engine, const Cell& cell) {
    char row[256];
    std::snprintf(row, sizeof row, "%s,%zu,%s,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g\n", workload.id.c_str(),
                  bodies, engine.id.c_str(), cell.micros, cell.ratio, cell.build_micros,
                  cell.joint_gap, cell.residual, cell.kinetic);
    csv += row;
}

int compare(const Options& options) {
    const std::vector<EngineKind> engines = select_kinds(all_engines(), options.engines);
    for (const EngineKind& engine : engines)
        std::printf("%s: %s\n", engine.id.c_str(), engine.label.c_str());
    std::string csv =
        "workload,bodies,engine,micros_per_second,ratio,build_micros,joint_gap_m,"
        "energy_residual_j,kinetic_energy_j\n";
    print_heading();
    for (const Workload& workload : select_kinds(all_workloads(), options.workloads)) {
        for (const std::size_t bodies : options.bodies) {
            const std::vector<BenchCreature> creatures = draw_creatures(options, bodies);
            std::vector<Cell> cells(engines.size());
            measure_time(options, engines, creatures, workload.environment, cells);
            measure_accuracy(options, engines, creatures, workload, cells);
            for (std::size_t e = 0; e < engines.size(); ++e) {
                print_cell(workload, bodies, engines[e], cells[e]);
                append_row(csv, workload, bodies, engines[e], cells[e]);
            }
            std::fflush(stdout);
        }
    }
    return write_table(options.csv_path, csv);
}

// Runs each creature once in each engine and measures nothing, for instruction counters.
int advance_only(const Options& options) {
    for (const Workload& workload : select_kinds(all_workloads(), options.workloads)) {
        for (const std::size_t bodies : options.bodies)
            for (const EngineKind& engine : select_kinds(all_engines(), options.engines))
                time_round({engine}, draw_creatures(options, bodies), workload.environment,
                           options.ticks());
    }
    return EXIT_SUCCESS;
}

}  // namespace
}  // namespace cambrian::bench

int main(int argc, char** argv) try {
    cambrian::bench::Options options;
    CLI::App app("Times the same creatures in Cambrian's physics, Box2D and MuJoCo");
    cambrian::bench::add_cell_options(app, options,
                                      "cambrian, box2d, box2d-torques, mujoco, mujoco-coarse");
    app.add_option("--csv", options.csv_path, "file to write the table to");
    CLI11_PARSE(app, argc, argv);
    return options.advance_only ? cambrian::bench::advance_only(options)
                                : cambrian::bench::compare(options);
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return EXIT_FAILURE;
}
