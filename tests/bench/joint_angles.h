#pragma once

// The error of a creature's joint angles after some time, against a computation whose own error is
// negligible.

#include "bench/bench_creature.h"
#include "world/environment.h"
#include "world/scene_settings.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace cambrian::bench {

// Returns settings for Dormand-Prince with a tolerance of 1e-7 and contact steps of 1/1920 s.
SceneSettings reference_settings();

struct JointRun {
    std::vector<double> angles;     // rad, one per joint, at the end
    std::uint64_t evaluations = 0;  // evaluations of the accelerations
};

JointRun run_joints(const BenchCreature& creature, const Environment& environment,
                    const SceneSettings& settings, std::size_t ticks);

// Returns the root mean square of the differences, in rad.
double root_mean_square_difference(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace cambrian::bench
