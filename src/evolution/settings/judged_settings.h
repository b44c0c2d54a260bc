#pragma once

#include "evolution/settings/experiment_settings.h"

namespace cambrian {

// Settings under which something judged once is judged again as it was; everything else is at its
// default. Of whatever has a seed, goal, world and expression.
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
