#pragma once

#include "core/random.h"
#include "planar/model/planar_model.h"

namespace cambrian {

// Returns a creature in motion: random joint angles, and speeds of some m/s and rad/s.
inline Motion random_motion(RandomStream& random, const PlanarModel& model) {
    Motion motion = rest_motion(model);
    for (int c = 0; c < coordinate_count(model); ++c) {
        motion.position[c] += 0.5 * random.gauss();
        motion.speed[c] = 3.0 * random.gauss();
    }
    return motion;
}

}  // namespace cambrian
