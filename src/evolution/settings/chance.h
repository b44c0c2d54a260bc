#pragma once

#include "simulator/trial.h"

namespace cambrian {

// Whether trials draw anything by chance: where the wall is, how the light moves, the shape of the
// ground, or what further trials change. Otherwise other seeds give the same trials.
inline bool has_chance(const TrialWorld& world) {
    const Environment& environment = world.environment;
    const TerrainSettings& terrain = environment.terrain;
    const TrialSettings& trial = world.trial;
    return environment.has_wall || (environment.has_light && environment.light_motion != "still") ||
           (!terrain.same && !terrain.is_flat()) ||
           (trial.trials > 1 && (trial.friction_jitter > 0.0 || trial.tilt_jitter > 0.0));
}

}  // namespace cambrian
