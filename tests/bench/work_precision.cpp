// cambrian_bench_precision: cost against error of all our integrators and of the other engines, on
// a passive chain that tumbles in empty space. The error is the distance of the parts from a
// reference, which is our best integrator at a very small tolerance. With --creatures, it surveys
// the tolerance of our physics on creatures in every world instead.

#include "bench/engine_kinds.h"
#include "bench/runs.h"
#include "bench/svg_plot.h"
#include "bench/tolerance_survey.h"
#include "bench/write_table.h"
#include "core/thread_time.h"
#include "dynamics/planar_scene.h"
#include "support/body_plans.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>

namespace cambrian::bench {
namespace {

constexpr std::size_t kBodies = 6;
constexpr double kFinestTolerance = 1e-12;
constexpr int kFinestSteps = 256;  // per tick; for the engine that checks the reference

struct Options {
    double seconds = 2.0;
    int repeats = 5;
    bool creatures = false;
    ToleranceSurvey survey;
    std::string csv_path;
    std::string svg_path;
};

// One curve: the same method with increasing precision.
struct Method {
    std::string label;
    std::vector<EngineKind> settings;  // labelled by the parameter that sets the precision
};

struct Outcome {
    double micros = 0.0;  // CPU time of a simulated second in microseconds, least of the repeats
    double error = 0.0;   // m, root mean square over the parts, greatest of all ticks
    double gap = 0.0;     // m, widest of all ticks
};

std::string tolerance_label(double tolerance) {
    char text[32];
    std::snprintf(text, sizeof text, "tolerance %.0e", tolerance);
    return text;
}
std::string step_label(int steps_per_tick) {
    return std::to_string(60 * steps_per_tick) + " Hz";
}

EngineKind planar_with(const std::string& integrator, double tolerance) {
    SceneSettings settings;
    settings.integrator = integrator;
    settings.tolerance = tolerance;
    EngineKind kind = planar_engine("cambrian", settings);
    kind.label = tolerance_label(tolerance);
    return kind;
}

Method planar_method(const std::string& integrator) {
    Method method{"Cambrian, " + integrator, {}};
    for (const double tolerance : {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11})
        method.settings.push_back(planar_with(integrator, tolerance));
    return method;
}

Method box2d_method(int velocity_iterations, int position_iterations) {
    Method method{"Box2D, " + std::to_string(velocity_iterations) + "/" +
                      std::to_string(position_iterations) + " iterations",
                  {}};
    for (int steps = 1; steps <= 64; steps *= 2) {
        method.settings.push_back(
            box2d_engine("box2d", {steps, velocity_iterations, position_iterations}));
        method.settings.back().label = step_label(steps);
    }
    return method;
}

Method mujoco_method(const std::string& label, MujocoIntegrator integrator) {
    Method method{"MuJoCo, " + label, {}};
    for (int steps = 1; steps <= 64; steps *= 2) {
        method.settings.push_back(mujoco_engine("mujoco", {steps, integrator}));
        method.settings.back().label = step_label(steps);
    }
    return method;
}

std::vector<Method> all_methods() {
    std::vector<Method> methods;
    for (const IntegratorName& integrator : planar_scene_kind().integrators)
        methods.push_back(planar_method(integrator.id));
    methods.push_back(box2d_method(8, 3));
    methods.push_back(box2d_method(50, 20));
    methods.push_back(mujoco_method("Euler", MujocoIntegrator::kEuler));
    methods.push_back(mujoco_method("RK4", MujocoIntegrator::kRungeKutta4));
    return methods;
}

// The motion of all parts at the end of every tick.
using Track = std::vector<std::vector<PartMotion>>;

Track track_run(const EngineKind& kind, const BenchCreature& chain, std::size_t ticks) {
    const auto engine = build_scene(kind, chain.plan, empty_space(), WorkAudit::kOff);
    Track track(ticks);
    for (std::size_t tick = 0; tick < ticks; ++tick) {
        advance_scene(*engine, chain, tick, tick + 1);
        engine->read_motion(track[tick]);
    }
    return track;
}

double root_mean_square_distance(const std::vector<PartMotion>& a,
                                 const std::vector<PartMotion>& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
        sum += (a[i].x - b[i].x) * (a[i].x - b[i].x) + (a[i].y - b[i].y) * (a[i].y - b[i].y);
    return std::sqrt(sum / static_cast<double>(a.size()));
}

// Returns the greatest distance of all ticks, since at a single tick an error may pass through 0.
double distance(const Track& a, const Track& b) {
    double greatest = 0.0;
    for (std::size_t tick = 0; tick < a.size(); ++tick)
        greatest = std::fmax(greatest, root_mean_square_distance(a[tick], b[tick]));
    return greatest;
}

Outcome measure(const EngineKind& kind, const BenchCreature& chain, const Track& truth,
                const Options& options) {
    constexpr double micro = 1e6;
    const auto ticks = static_cast<std::size_t>(std::lround(options.seconds / kTestTick));
    Outcome outcome;
    for (int repeat = 0; repeat < options.repeats; ++repeat) {
        const auto engine = build_scene(kind, chain.plan, empty_space(), WorkAudit::kOff);
        const double start = thread_cpu_time();
        advance_scene(*engine, chain, 0, ticks);
        const double micros = micro * (thread_cpu_time() - start) / options.seconds;
        outcome.micros = repeat == 0 ? micros : std::fmin(outcome.micros, micros);
    }
    const Track track = track_run(kind, chain, ticks);
    outcome.error = distance(track, truth);
    for (const std::vector<PartMotion>& parts : track)
        outcome.gap = std::fmax(outcome.gap, widest_joint_gap(chain.plan, parts));
    return outcome;
}

// Returns the run of the integrator that is closest to an independent one: the other
// double-precision engine, with very small steps.
Track find_truth(const BenchCreature& chain, std::size_t ticks) {
    const Track opinion = track_run(
        mujoco_engine("mujoco", {kFinestSteps, MujocoIntegrator::kRungeKutta4}), chain, ticks);
    Track truth;
    double least = 0.0;
    for (const IntegratorName& integrator : planar_scene_kind().integrators) {
        const Track track = track_run(planar_with(integrator.id, kFinestTolerance), chain, ticks);
        const double apart = distance(track, opinion);
        if (truth.empty() || apart < least) {
            truth = track;
            least = apart;
        }
    }
    std::printf("# reference and MuJoCo RK4 at %s differ by %.1e m\n",
                step_label(kFinestSteps).c_str(), least);
    return truth;
}

int tell(const Options& options, const std::string& csv, const Plot& plot) {
    std::fputs(csv.c_str(), stdout);
    return std::max(write_table(options.csv_path, csv),
                    write_table(options.svg_path, to_svg(plot)));
}

int run_creatures(const Options& options) {
    const SurveyedTolerances found = survey_tolerances(options.survey);
    return tell(options, found.csv, found.plot);
}

int run_chain(const Options& options) {
    const auto ticks = static_cast<std::size_t>(std::lround(options.seconds / kTestTick));
    const BenchCreature chain = passive_chain(kBodies, ticks);
    const Track truth = find_truth(chain, ticks);
    Plot plot{"Work and precision: a passive chain of six, two seconds",
              "CPU time of a simulated second, microseconds",
              "error of positions, m",
              {}};
    std::string csv = "method,setting,micros_per_second,error_m,joint_gap_m\n";
    for (const Method& method : all_methods()) {
        PlotSeries series{method.label, {}};
        for (const EngineKind& setting : method.settings) {
            const Outcome outcome = measure(setting, chain, truth, options);
            // Methods with fixed or limited steps give equal errors where the setting has no
            // effect.
            if (!series.points.empty() && outcome.error == series.points.back().y) continue;
            char row[256];
            std::snprintf(row, sizeof row, "\"%s\",%s,%.4g,%.4g,%.4g\n", method.label.c_str(),
                          setting.label.c_str(), outcome.micros, outcome.error, outcome.gap);
            csv += row;
            series.points.push_back({outcome.micros, outcome.error});
        }
        plot.series.push_back(series);
    }
    return tell(options, csv, plot);
}

}  // namespace
}  // namespace cambrian::bench

int main(int argc, char** argv) try {
    cambrian::bench::Options options;
    CLI::App app("Cost against error on a passive chain, for every integrator and engine");
    app.add_option("--seconds", options.seconds, "simulated time, s")->check(CLI::PositiveNumber);
    app.add_option("--repeats", options.repeats, "the least time of them counts")
        ->check(CLI::PositiveNumber);
    app.add_flag("--creatures", options.creatures,
                 "instead, what our tolerance comes to on creatures in air, in water and on the "
                 "ground: errors of joint angles and evaluations");
    app.add_option("--bodies", options.survey.bodies, "sizes of these creatures")
        ->check(CLI::Range(2, 32));
    app.add_option("--threads", options.survey.threads, "for these creatures")
        ->check(CLI::PositiveNumber);
    app.add_option("--csv", options.csv_path, "file to write the table to");
    app.add_option("--svg", options.svg_path, "file to write the plot to");
    CLI11_PARSE(app, argc, argv);
    return options.creatures ? cambrian::bench::run_creatures(options)
                             : cambrian::bench::run_chain(options);
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return EXIT_FAILURE;
}
