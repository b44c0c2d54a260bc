#include "bench/joint_angles.h"

#include "bench/planar_runs.h"
#include "planar/planar_scene.h"

#include <cmath>

namespace cambrian::bench {

SceneSettings reference_settings() {
    SceneSettings settings;
    settings.integrator = planar_scene_kind().accurate_integrator;
    settings.tolerance = 1e-7;
    settings.contact_step = 1.0 / 1920;
    settings.max_evaluations = 1e9;
    return settings;
}

JointRun run_joints(const BenchCreature& creature, const Environment& environment,
                    const SceneSettings& settings, std::size_t ticks) {
    const auto scene = make_planar_scene(creature.plan, environment, settings);
    for (std::size_t tick = 0; tick < ticks; ++tick)
        advance_planar_scene(*scene, creature, tick);
    JointRun run;
    for (std::size_t part = 1; part < scene->part_count(); ++part)
        run.angles.push_back(scene->joint_coordinate(part));
    run.evaluations = scene->audit().evaluations;
    return run;
}

double root_mean_square_difference(const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
        sum += (a[i] - b[i]) * (a[i] - b[i]);
    return std::sqrt(sum / static_cast<double>(a.size()));
}

}  // namespace cambrian::bench
