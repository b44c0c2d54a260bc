#include "bench/tolerance_survey.h"

#include "bench/joint_angles.h"
#include "core/sample_statistics.h"
#include "core/threads/thread_pool.h"
#include "support/body_plans.h"
#include "support/workload.h"

#include <array>
#include <cmath>
#include <cstdio>

namespace cambrian::bench {
namespace {

constexpr std::array kTolerances = {3e-2, 1e-2, 4e-3, 2e-3, 1e-3, 3e-4, 1e-4, 3e-5, 1e-5};

// The figures of one creature, one entry per tolerance.
struct Measured {
    std::array<double, kTolerances.size()> error = {};        // rad
    std::array<double, kTolerances.size()> evaluations = {};  // per simulated second
};

Measured measure(const BenchCreature& creature, const Environment& environment, std::size_t ticks) {
    const std::vector<double> truth =
        run_joints(creature, environment, reference_settings(), ticks).angles;
    Measured measured;
    for (std::size_t i = 0; i < kTolerances.size(); ++i) {
        SceneSettings settings;
        settings.tolerance = kTolerances[i];
        const JointRun run = run_joints(creature, environment, settings, ticks);
        measured.error[i] = root_mean_square_difference(run.angles, truth);
        measured.evaluations[i] =
            static_cast<double>(run.evaluations) / (static_cast<double>(ticks) * kTestTick);
    }
    return measured;
}

std::vector<Measured> measure_all(const ToleranceSurvey& survey, const Environment& environment,
                                  std::size_t bodies) {
    const auto ticks = static_cast<std::size_t>(std::lround(survey.seconds / kTestTick));
    std::vector<Measured> all(survey.creatures);
    ThreadPool(survey.threads).parallel_for(survey.creatures, [&](std::size_t i, std::size_t) {
        all[i] = measure(random_creature(bodies, i, ticks), environment, ticks);
    });
    return all;
}

double median_of(const std::vector<Measured>& all, auto member, std::size_t tolerance) {
    std::vector<double> values;
    for (const Measured& each : all)
        values.push_back((each.*member)[tolerance]);
    return median(values);
}

}  // namespace

SurveyedTolerances survey_tolerances(const ToleranceSurvey& survey) {
    SurveyedTolerances found{"workload,bodies,tolerance,error_rad,evaluations_per_second\n",
                             {"What the tolerance comes to, in every world",
                              "tolerance",
                              "error of joint angles after half a second, rad",
                              {}}};
    for (const Workload& workload : all_workloads()) {
        for (const std::size_t bodies : survey.bodies) {
            const auto all = measure_all(survey, workload.environment, bodies);
            PlotSeries series{workload.id + ", " + std::to_string(bodies) + " bodies", {}};
            for (std::size_t i = 0; i < kTolerances.size(); ++i) {
                const double error = median_of(all, &Measured::error, i);
                char row[128];
                std::snprintf(row, sizeof row, "%s,%zu,%g,%.3g,%.4g\n", workload.id.c_str(), bodies,
                              kTolerances[i], error, median_of(all, &Measured::evaluations, i));
                found.csv += row;
                series.points.push_back({kTolerances[i], error});
            }
            found.plot.series.push_back(series);
        }
    }
    return found;
}

}  // namespace cambrian::bench
