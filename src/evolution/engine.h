#pragma once

// The thread that evolves. Commands in, snapshots out; shares nothing mutable with its user but the
// progress counters. send() and latest() belong to one thread, the user's.

#include "core/snapshot_channel.h"
#include "evolution/command.h"
#include "evolution/evaluation_backend.h"
#include "evolution/evolution.h"
#include "evolution/snapshot.h"

#include <memory>
#include <optional>
#include <thread>

namespace cambrian {

class EvolutionEngine {
public:
    // Begins paused at generation 0 of the settings, which must pass check_settings.
    EvolutionEngine(SettingsPtr settings, const EvolutionKinds& kinds,
                    std::unique_ptr<EvaluationBackend> backend);
    ~EvolutionEngine();  // stops within one trial
    EvolutionEngine(const EvolutionEngine&) = delete;
    EvolutionEngine& operator=(const EvolutionEngine&) = delete;

    // False if the inbox is full; try again next frame.
    bool send(Command command);
    // Newest snapshot; never null.
    const std::shared_ptr<const EvolutionSnapshot>& latest();
    const EvaluationProgress& progress() const { return progress_; }

private:
    void run(const std::stop_token& stop);
    void run_generation(const std::stop_token& interrupted);
    void record_generation();
    void apply(PauseEvolution command);
    void apply(ResumeEvolution command);
    void apply(StepGeneration command);
    void apply(ChangeSettings command);
    void apply(InjectGenome command);
    void apply(AddNewcomers command);
    void apply(StartExperiment command);
    void publish();

    const EvolutionKinds& kinds_;
    std::unique_ptr<EvaluationBackend> backend_;
    EngineInbox inbox_;
    SnapshotChannel<EvolutionSnapshot> snapshots_;
    EvaluationProgress progress_;

    // Engine thread only.
    std::optional<Evolution> evolution_;
    EvolutionSnapshot shown_;
    int generations_to_run_ = 0;  // -1: until paused

    std::jthread thread_;  // last: started after, joined before everything else
};

}  // namespace cambrian
