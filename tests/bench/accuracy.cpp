// cambrian_bench_accuracy: the accuracy of our physics on the creatures used to compare engines. It
// measures gaps at joints, conservation of momentum, joint angles against a precise computation,
// the energy that contacts and stops add, mirror images, and the steps needed. The output is CSV
// with one row per figure.

#include "bench/engine_kinds.h"
#include "bench/joint_angles.h"
#include "bench/mirror_image.h"
#include "bench/planar_runs.h"
#include "bench/runs.h"
#include "bench/selection.h"
#include "bench/write_table.h"
#include "core/sample_statistics.h"
#include "core/threads/thread_pool.h"
#include "support/body_plans.h"
#include "support/workload.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <functional>
#include <string>

namespace cambrian::bench {
namespace {

struct Options {
    std::vector<std::string> measures;  // ids; all if empty
    std::vector<std::size_t> bodies = {3, 6, 12, 24};
    std::size_t creatures = 20;
    double seconds = 10.0;
    double accuracy_seconds = 0.5;  // s after which joint angles are compared
    std::uint64_t seed = 1;
    std::size_t threads = 1;
    std::string csv_path;
};

std::size_t ticks_in(double seconds) {
    return static_cast<std::size_t>(std::lround(seconds / kTestTick));
}

// Returns the function's value for each creature, computed on all threads.
template <class Function>
auto of_creatures(const Options& options, std::size_t bodies, double seconds, Function value_of) {
    std::vector<decltype(value_of(BenchCreature()))> values(options.creatures);
    ThreadPool(options.threads).parallel_for(options.creatures, [&](std::size_t i, std::size_t) {
        values[i] = value_of(random_creature(bodies, options.seed + i, ticks_in(seconds)));
    });
    return values;
}

// Returns one number of each item.
template <class Each, class Number>
std::vector<double> values_of(const std::vector<Each>& all, Number number_of) {
    std::vector<double> values;
    for (const Each& each : all)
        values.push_back(std::invoke(number_of, each));
    return values;
}

class Table {
public:
    void add(const char* measure, const std::string& workload, std::size_t bodies,
             const char* figure, double value) {
        char row[256];
        std::snprintf(row, sizeof row, "%s,%s,%zu,%s,%.6g\n", measure, workload.c_str(), bodies,
                      figure, value);
        std::fputs(row, stdout);
        std::fflush(stdout);
        csv_ += row;
    }
    void print_header() const { std::fputs(csv_.c_str(), stdout); }
    const std::string& csv() const { return csv_; }

private:
    std::string csv_ = "measure,workload,bodies,figure,value\n";
};

// --- audit: the energy audit of a run ---------------------------------------------------------

SceneAudit audit_of(const BenchCreature& creature, const Environment& environment,
                    std::size_t ticks) {
    const auto scene = make_planar_scene(creature.plan, environment);
    for (std::size_t tick = 0; tick < ticks; ++tick)
        advance_planar_scene(*scene, creature, tick);
    return scene->audit();
}

void measure_audits(const Options& options, Table& table) {
    const std::size_t ticks = ticks_in(options.seconds);
    const auto a_second = [&](std::uint64_t SceneAudit::*count) {
        return [&options, count](const SceneAudit& audit) {
            return static_cast<double>(audit.*count) / options.seconds;
        };
    };
    for (const Workload& workload : all_workloads()) {
        for (const std::size_t bodies : options.bodies) {
            const auto audits =
                of_creatures(options, bodies, options.seconds, [&](const BenchCreature& creature) {
                    return audit_of(creature, workload.environment, ticks);
                });
            const auto add_mean = [&](const char* figure, auto number_of) {
                table.add("audit", workload.id, bodies, figure, mean(values_of(audits, number_of)));
            };
            add_mean("evaluations a second", a_second(&SceneAudit::evaluations));
            add_mean("steps a second", a_second(&SceneAudit::steps));
            add_mean("rejections a second", a_second(&SceneAudit::rejections));
            add_mean("impacts a second", a_second(&SceneAudit::events));
            add_mean("fallbacks a second", a_second(&SceneAudit::fallbacks));
            add_mean("percent given", [](const SceneAudit& audit) {
                return 100.0 * audit.positive_work / audit.energy_scale;
            });
            add_mean("percent unexplained", [](const SceneAudit& audit) {
                return 100.0 * std::fabs(audit.energy_residual) / audit.energy_scale;
            });
        }
    }
}

// --- joints: the widest gap of all creatures and ticks -----------------------------------------

double widest_gap(const BenchCreature& creature, const Environment& environment,
                  std::size_t ticks) {
    return watch_run(planar_engine("cambrian", {}), creature, environment, ticks)
        .greatest_joint_gap;
}

void measure_gaps(const Options& options, Table& table) {
    for (const Workload& workload : all_workloads()) {
        for (const std::size_t bodies : options.bodies) {
            const auto gaps =
                of_creatures(options, bodies, options.seconds, [&](const BenchCreature& creature) {
                    return widest_gap(creature, workload.environment, ticks_in(options.seconds));
                });
            table.add("gap", workload.id, bodies, "widest m", greatest(gaps));
        }
    }
}

// --- momentum: it must not change when muscles work in empty space -----------------------------

struct Momentum {
    double angular = 0.0;  // kg m^2/s, about the centre of mass
    double gross = 0.0;    // the same with the absolute values of all parts
};

Momentum momentum_of(const PhysicsScene& scene, const BodyPlan& plan, double density) {
    Momentum momentum;
    const Vec3 center = scene.center_of_mass();
    const Vec3 velocity = scene.center_of_mass_velocity();
    for (std::size_t part = 0; part < plan.parts.size(); ++part) {
        const Vec3& half = plan.parts[part].half_extents;
        const double mass = 4 * density * half.x() * half.y();
        const double inertia = mass * half.head<2>().squaredNorm() / 3;
        const Twist twist = scene.part_twist(part);
        const Vec3 arm = scene.part_pose(part).position - center;
        const double orbital = mass * arm.cross(twist.linear - velocity).z();
        const double spin = inertia * twist.angular.z();
        momentum.angular += orbital + spin;
        momentum.gross += std::fabs(orbital) + std::fabs(spin);
    }
    return momentum;
}

struct Drift {
    double center = 0.0;   // m, displacement of the centre of mass
    double angular = 0.0;  // change of angular momentum, relative to the greatest gross value
};

Drift drift_of(const BenchCreature& creature, std::size_t ticks) {
    const Environment environment = empty_space();
    const auto scene = make_planar_scene(creature.plan, environment);
    const Vec3 start = scene->center_of_mass();
    Drift drift;
    double gross = 0.0;
    for (std::size_t tick = 0; tick < ticks; ++tick) {
        advance_planar_scene(*scene, creature, tick);
        const Momentum momentum = momentum_of(*scene, creature.plan, environment.density);
        drift.center = std::fmax(drift.center, (scene->center_of_mass() - start).norm());
        drift.angular = std::fmax(drift.angular, std::fabs(momentum.angular));
        gross = std::fmax(gross, momentum.gross);
    }
    drift.angular /= gross;
    return drift;
}

void measure_momentum(const Options& options, Table& table) {
    const std::size_t ticks = ticks_in(options.seconds);
    for (const std::size_t bodies : options.bodies) {
        const auto drifts =
            of_creatures(options, bodies, options.seconds,
                         [&](const BenchCreature& creature) { return drift_of(creature, ticks); });
        const auto worst = [&](double Drift::*size) { return greatest(values_of(drifts, size)); };
        table.add("momentum", "empty", bodies, "farthest m", worst(&Drift::center));
        table.add("momentum", "empty", bodies, "angular share", worst(&Drift::angular));
    }
}

// --- angles: joint angles against a precise computation ----------------------------------------

void measure_angles(const Options& options, Table& table) {
    const std::size_t ticks = ticks_in(options.accuracy_seconds);
    for (const Workload& workload : all_workloads()) {
        for (const std::size_t bodies : options.bodies) {
            const auto errors = of_creatures(
                options, bodies, options.accuracy_seconds, [&](const BenchCreature& creature) {
                    const auto run = [&](const SceneSettings& settings) {
                        return run_joints(creature, workload.environment, settings, ticks).angles;
                    };
                    return root_mean_square_difference(run({}), run(reference_settings()));
                });
            table.add("angles", workload.id, bodies, "median rad", median(errors));
        }
    }
}

// --- mirror images -----------------------------------------------------------------------------

// Returns the greatest distance, in m, of a part at the end from its place in the mirror image.
double mirror_difference(const BenchCreature& creature, const Environment& environment, Flip flip) {
    const BenchCreature image = mirror_image(creature, flip);
    const auto scene = make_planar_scene(creature.plan, environment);
    const auto mirrored = make_planar_scene(image.plan, environment);
    const std::size_t parts = creature.plan.parts.size();
    for (std::size_t tick = 0; tick * parts < creature.targets.size(); ++tick) {
        advance_planar_scene(*scene, creature, tick);
        advance_planar_scene(*mirrored, image, tick);
    }
    double farthest = 0.0;
    for (std::size_t part = 0; part < parts; ++part) {
        const Vec3 position = scene->part_pose(part).position;
        const Vec3 shown = mirrored->part_pose(part).position;
        farthest =
            std::fmax(farthest, std::hypot(position.x() + shown.x(), position.y() - shown.y()));
    }
    return farthest;
}

void measure_mirrors(const Options& options, Table& table) {
    for (const Workload& workload : all_workloads()) {
        for (const std::size_t bodies : options.bodies) {
            const auto differences =
                of_creatures(options, bodies, options.seconds, [&](const BenchCreature& creature) {
                    return std::fmax(
                        mirror_difference(creature, workload.environment, Flip::kLength),
                        mirror_difference(creature, workload.environment, Flip::kWidth));
                });
            table.add("mirror", workload.id, bodies, "median m", median(differences));
            table.add("mirror", workload.id, bodies, "worst m", greatest(differences));
        }
    }
}

// -------------------------------------------------------------------------------------------------

struct Measure {
    std::string id;
    void (*run)(const Options&, Table&);
};

std::vector<Measure> all_measures() {
    return {{"audit", measure_audits},
            {"gap", measure_gaps},
            {"momentum", measure_momentum},
            {"angles", measure_angles},
            {"mirror", measure_mirrors}};
}

int measure(const Options& options) {
    Table table;
    table.print_header();
    for (const Measure& each : select_kinds(all_measures(), options.measures))
        each.run(options, table);
    return write_table(options.csv_path, table.csv());
}

}  // namespace
}  // namespace cambrian::bench

int main(int argc, char** argv) try {
    cambrian::bench::Options options;
    CLI::App app("What our physics is worth besides its speed, a row a figure");
    app.add_option("--measure", options.measures,
                   "audit, gap, momentum, angles, mirror; all by default");
    app.add_option("--bodies", options.bodies, "bodies a creature");
    app.add_option("--creatures", options.creatures, "creatures a cell")
        ->check(CLI::PositiveNumber);
    app.add_option("--seconds", options.seconds, "simulated time of a run, s")
        ->check(CLI::PositiveNumber);
    app.add_option("--seed", options.seed, "of the first creature");
    app.add_option("--threads", options.threads)->check(CLI::PositiveNumber);
    app.add_option("--csv", options.csv_path, "file to write the rows to");
    CLI11_PARSE(app, argc, argv);
    return cambrian::bench::measure(options);
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return EXIT_FAILURE;
}
