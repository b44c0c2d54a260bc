#pragma once

// The thread that computes a preserve while the user watches it. It receives commands and publishes
// pictures, and shares no other data. send() and latest() must be called by one thread.

#include "core/stopwatch.h"
#include "core/threads/snapshot_channel.h"
#include "core/threads/thread_pool.h"
#include "core/threads/thread_share.h"
#include "core/threads/worker_inbox.h"
#include "preserve/engine/pacing.h"
#include "preserve/engine/preserve_command.h"
#include "preserve/engine/preserve_log.h"
#include "preserve/engine/preserve_picture.h"
#include "preserve/preserve.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace cambrian {

// A preserve to go on with.
struct PreserveStart {
    std::unique_ptr<Preserve> preserve;
    std::unique_ptr<PreserveLog> log;  // null: it is not kept
    std::vector<SeriesRow> series;     // its past
    std::vector<MuseumPiece> museum = {};
};

class PreserveEngine {
public:
    // Starts paused. `threads` compute the ticks.
    PreserveEngine(PreserveStart start, const ThreadShare& threads);
    // Stops the thread within a tick and keeps the preserve in its log.
    ~PreserveEngine();
    PreserveEngine(const PreserveEngine&) = delete;
    PreserveEngine& operator=(const PreserveEngine&) = delete;

    void send(PreserveCommand command) { inbox_.send(std::move(command)); }
    // Returns the newest picture; never null.
    const std::shared_ptr<const PreservePicture>& latest() { return pictures_.latest(); }

private:
    void run(const std::stop_token& stop);
    void work(ThreadPool& pool, const std::stop_token& stop);
    template <class Work>
    void guard(const Work& work);
    void obey();
    void advance(ThreadPool& pool, const std::stop_token& interrupted);
    void tick(ThreadPool& pool);
    void take_chronicle();
    void write();
    void keep();
    void stop_with(std::string failure);
    void tell(PreserveNews news);
    void apply(PlayPreserve command);
    void apply(StepPreserve command);
    void apply(PacePreserve command);
    void apply(const Intervene& command);
    void apply(KeepPins command);
    void apply(WatchBrain command);
    void publish();

    WorkerInbox<PreserveCommand> inbox_;
    SnapshotChannel<PreservePicture> pictures_;

    // The following members are used by the thread only.
    PreserveStart start_;
    ThreadShare threads_;
    Pacing pacing_;
    Chronicle unwritten_;
    std::optional<Pins> unwritten_pins_;  // if they changed
    PreserveCamera camera_;
    PreservePicture shown_;  // all but what publish() takes from the preserve
    Stopwatch published_;
    bool single_tick_ = false;

    std::jthread thread_;  // last member, so that it is joined before the others are destroyed
};

}  // namespace cambrian
