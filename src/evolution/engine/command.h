#pragma once

#include "core/threads/worker_inbox.h"
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

// What may be asked of a running engine. Plain values; they take effect between generations,
// pausing between trials.
struct PauseEvolution {};
struct ResumeEvolution {};
struct StepGeneration {};  // one more generation, then pause
struct ChangeSettings {
    SettingsPtr settings;
};
struct InjectGenome {
    GenomePtr genome;
};
// A share (0 to 1) of the next offspring places goes, once, to new random creatures.
struct AddNewcomers {
    double share = 0.2;
};
// Everyone is judged again in the present generation: the scores were given by a simulator that
// moved them otherwise.
struct RescorePopulation {};
// Starts a new experiment, paused, at generation 0.
struct StartExperiment {
    SettingsPtr settings;
    std::vector<GenomePtr> founders;               // empty: random
    std::shared_ptr<ExperimentLog> log = nullptr;  // to be kept there; null: nowhere
};
// Goes on, paused, where an experiment was left.
struct ContinueExperiment {
    std::shared_ptr<const SavedExperiment> saved;
    std::shared_ptr<ExperimentLog> log = nullptr;  // that it came from; null: not kept any more
};
// Evaluates elsewhere from now on, the rest of the generation in flight included; not null. What
// evolves is the same.
struct UseBackend {
    std::shared_ptr<EvaluationBackend> backend;
};

using EngineCommand =
    std::variant<PauseEvolution, ResumeEvolution, StepGeneration, ChangeSettings, InjectGenome,
                 AddNewcomers, RescorePopulation, StartExperiment, ContinueExperiment, UseBackend>;
using EngineInbox = WorkerInbox<EngineCommand, 256>;

}  // namespace cambrian
