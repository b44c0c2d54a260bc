#pragma once

// How far off the joints of a creature are after a while, against a computation that is exact for
// this purpose.

#include "bench/bench_creature.h"
#include "world/environment.h"
#include "world/scene_settings.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace cambrian::bench {

// Dormand-Prince at a tolerance of 1e-7 with contact steps of 1/1920 s.
SceneSettings reference_settings();

struct JointRun {
    std::vector<double> angles;     // rad, one a joint, at the end
    std::uint64_t evaluations = 0;  // of the accelerations, in all
};

JointRun run_joints(const BenchCreature& creature, const Environment& environment,
                    const SceneSettings& settings, std::size_t ticks);

// rad
double root_mean_square_difference(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace cambrian::bench
