#pragma once

// Where the time of one evaluation goes. The trial is run twice: as evolution does, and as bare
// physics that gets the same motor targets; the difference is control and bookkeeping.

#include "evolution/kinds/evolution_kinds.h"
#include "evolution/settings/experiment_settings.h"

namespace cambrian::bench {

// CPU time of one thread, s.
struct EvaluationCost {
    double expression = 0.0;
    double trial = 0.0;    // physics, control and bookkeeping
    double physics = 0.0;  // building the scene and moving it
    double scoring = 0.0;

    double control() const { return trial - physics; }
    double total() const { return expression + trial + scoring; }
    EvaluationCost& operator+=(const EvaluationCost& other);
};

// Of a valid genome that completes its trial.
EvaluationCost measure_cost(const Genome& genome, const ExperimentSettings& settings,
                            const EvolutionKinds& kinds);

}  // namespace cambrian::bench
