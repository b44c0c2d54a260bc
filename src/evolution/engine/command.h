#pragma once

#include "evolution/settings/experiment_settings.h"
#include "genome/genome.h"

#include <cstdint>
#include <memory>
#include <variant>
#include <vector>

namespace cambrian {

class EvaluationBackend;
class ExperimentLog;
struct SavedExperiment;

// Commands to a running engine, as plain values. They take effect between generations; a pause
// takes effect between trials.
struct PauseEvolution {};
struct ResumeEvolution {};
struct StepGeneration {};  // one more generation, then pause
struct ChangeSettings {
    SettingsPtr settings;
};
struct InjectGenome {
    GenomePtr genome;
};
// Gives a share (0 to 1) of the next offspring places, once, to random immigrants.
struct AddImmigrants {
    double share = 0.2;
};
// Evaluates the present generation again, because its scores come from another simulator version.
struct RescorePopulation {};
// Starts a new experiment, paused, at generation 0.
struct StartExperiment {
    SettingsPtr settings;
    std::vector<GenomePtr> founders;               // empty for random creatures
    std::shared_ptr<ExperimentLog> log = nullptr;  // stores the experiment; null: not stored
};
// Continues an experiment where it ended; it starts paused.
struct ContinueExperiment {
    std::shared_ptr<const SavedExperiment> saved;
    std::shared_ptr<ExperimentLog> log = nullptr;  // the log it came from; null: no longer stored
};
// Changes the back-end, which must not be null, from now on, also for the rest of the present
// generation. The results do not depend on it.
struct UseBackend {
    std::shared_ptr<EvaluationBackend> backend;
};

using EngineCommand =
    std::variant<PauseEvolution, ResumeEvolution, StepGeneration, ChangeSettings, InjectGenome,
                 AddImmigrants, RescorePopulation, StartExperiment, ContinueExperiment, UseBackend>;

}  // namespace cambrian
