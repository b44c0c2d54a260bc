#pragma once

#include "evolution/settings/experiment_settings.h"

namespace cambrian {

// Returns settings that repeat an evaluation: seed, goal, world and expression are those of its
// record. All others have their default.
template <class Judged>
ExperimentSettings settings_of(const Judged& judged) {
    ExperimentSettings settings;
    settings.seed = judged.seed;
    settings.goal = judged.goal;
    settings.world = judged.world;
    settings.expression = judged.expression;
    return settings;
}

}  // namespace cambrian
