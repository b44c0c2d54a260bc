#pragma once

// The engine evolves on a thread of its own. It receives commands and publishes snapshots; it
// shares no mutable data with its user except progress counters. Only one thread may call send()
// and latest().

#include "core/stopwatch.h"
#include "core/threads/snapshot_channel.h"
#include "core/threads/worker_inbox.h"
#include "evolution/engine/command.h"
#include "evolution/engine/experiment_log.h"
#include "evolution/engine/snapshot.h"
#include "evolution/evaluation/evaluation_backend.h"
#include "evolution/evolution.h"

#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace cambrian {

class EvolutionEngine {
public:
    // Starts paused at generation 0 of the settings, which must pass check_settings(). Without a
    // log the experiment is not stored.
    EvolutionEngine(SettingsPtr settings, const EvolutionKinds& kinds,
                    std::shared_ptr<EvaluationBackend> backend,
                    std::shared_ptr<ExperimentLog> log = nullptr);
    ~EvolutionEngine();  // stops the thread within the duration of one trial
    EvolutionEngine(const EvolutionEngine&) = delete;
    EvolutionEngine& operator=(const EvolutionEngine&) = delete;

    // Commands act between trials: a running batch is interrupted and continues afterwards.
    void send(EngineCommand command) { inbox_.send(std::move(command)); }
    // Returns the newest snapshot; never null.
    const std::shared_ptr<const EvolutionSnapshot>& latest() { return snapshots_.latest(); }
    const EvaluationProgress& progress() const { return progress_; }

private:
    void run(const std::stop_token& stop);
    void run_generation(const std::stop_token& interrupted);
    void audit_champion(const std::stop_token& interrupted);
    void show_generation();
    void start_showing(std::shared_ptr<ExperimentLog> log);
    bool steer(const SteeringCommand& command);
    Status keep_notes();
    Status keep_generation();
    void stop_with(std::string failure);
    void apply(PauseEvolution command);
    void apply(ResumeEvolution command);
    void apply(StepGeneration command);
    void apply(ChangeSettings command);
    void apply(InjectGenome command);
    void apply(AddImmigrants command);
    void apply(RescorePopulation command);
    void apply(StartExperiment command);
    void apply(ContinueExperiment command);
    void apply(UseBackend command);
    void publish();

    const EvolutionKinds& kinds_;
    WorkerInbox<EngineCommand> inbox_;
    SnapshotChannel<EvolutionSnapshot> snapshots_;
    EvaluationProgress progress_;

    // The following members are used by the engine's thread only.
    std::shared_ptr<EvaluationBackend> backend_;
    std::optional<Evolution> evolution_;
    // The newest generation as it was before it bred, until its champion is audited.
    std::optional<EvolutionState> unaudited_;
    EvolutionSnapshot shown_;
    int generations_to_run_ = 0;  // -1 until paused
    double evaluating_ = 0.0;     // s spent on the present generation

    std::shared_ptr<ExperimentLog> log_;
    std::optional<StartExperiment> unkept_start_;  // waits until the log has stored it
    std::deque<NotedCommand> unkept_notes_;
    // Commands that arrived while an evaluated generation could not be stored; they apply to the
    // next one.
    std::vector<SteeringCommand> deferred_;

    std::jthread thread_;  // last member, so that it is joined before the others are destroyed
};

}  // namespace cambrian
