#pragma once

// The thread that breeds grids while the user looks at one. It receives commands and publishes
// snapshots; only progress counters are shared. send() and latest() must be called by one thread.

#include "core/threads/snapshot_channel.h"
#include "core/threads/worker_inbox.h"
#include "evolution/evaluation/evaluation_backend.h"
#include "picking/picking_session.h"

#include <memory>
#include <thread>
#include <utility>

namespace cambrian {

class PickingEngine {
public:
    // The settings must pass check_settings(); `kinds` must outlive the object.
    PickingEngine(SettingsPtr settings, const EvolutionKinds& kinds,
                  std::unique_ptr<EvaluationBackend> backend);
    ~PickingEngine();  // stops the thread within the duration of one trial
    PickingEngine(const PickingEngine&) = delete;
    PickingEngine& operator=(const PickingEngine&) = delete;

    void send(PickingCommand command) { inbox_.send(std::move(command)); }
    // Returns the newest snapshot; never null.
    const std::shared_ptr<const PickingSnapshot>& latest() { return snapshots_.latest(); }
    const EvaluationProgress& progress() const { return progress_; }

private:
    void run(const std::stop_token& stop);
    void work(const std::stop_token& interrupted);
    void publish();

    std::unique_ptr<EvaluationBackend> backend_;
    WorkerInbox<PickingCommand> inbox_;
    SnapshotChannel<PickingSnapshot> snapshots_;
    EvaluationProgress progress_;
    PickingSession session_;  // used by the thread only
    std::jthread thread_;     // last member, so that it is joined before the others are destroyed
};

}  // namespace cambrian
