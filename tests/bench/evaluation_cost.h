#pragma once

// The CPU time of the parts of one evaluation. The trial is run twice: as evolution does, and as
// bare physics with the same motor targets. The difference is the time of control and records.

#include "evolution/kinds/evolution_kinds.h"
#include "evolution/settings/experiment_settings.h"

namespace cambrian::bench {

// CPU time on one thread, in s.
struct EvaluationCost {
    double expression = 0.0;
    double trial = 0.0;    // physics, control and records
    double physics = 0.0;  // building and advancing the scene
    double scoring = 0.0;

    double control() const { return trial - physics; }
    double total() const { return expression + trial + scoring; }
    EvaluationCost& operator+=(const EvaluationCost& other);
};

// The genome must be valid and complete its trial.
EvaluationCost measure_cost(const Genome& genome, const ExperimentSettings& settings,
                            const EvolutionKinds& kinds);

}  // namespace cambrian::bench
