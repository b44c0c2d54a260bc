#pragma once

// A run on a cluster whose server is in memory and whose workers are threads. Any worker can be
// made to disappear. The run's digests are compared with those of the same run on one thread.

#include "cluster/coordinator/cluster_backend.h"
#include "cluster/memory_work_queue.h"
#include "cluster/worker/worker.h"
#include "evolution/settings/experiment_settings.h"

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

namespace cambrian::test {

// Returns settings of 12 generations with 60 creatures that walk for a few seconds.
ExperimentSettings drill_settings();

// One digest per generation.
using Digests = std::vector<std::uint64_t>;
Digests local_digests(const ExperimentSettings& settings);

// Returns the digests of that run with another back-end; fewer if an evaluation fails. `between` is
// called before each generation with its number.
Digests digests_of_run(const ExperimentSettings& settings, EvaluationBackend& backend,
                       const std::function<void(int)>& between = {});

struct WorkerHabits {
    // Whether the worker disappears with this unit in hand, like a killed process.
    std::function<bool(const UnitMessage&)> dies_of;
    // Called before a result is published.
    std::function<void(UnitMessage&)> changes;
    std::chrono::milliseconds slow{0};  // delay per unit
    std::string login = "lab";
};

class DrillWorker {
public:
    DrillWorker(MemoryServer& server, std::uint64_t id, WorkerHabits habits = {});
    ~DrillWorker();

    // The worker disappears without a message.
    void kill();
    bool dead() const { return *dead_; }
    // Blocks the worker's messages, or lets them pass again.
    void cut_off(bool off) { *cut_off_ = off; }
    std::vector<std::string> said() const;

private:
    std::shared_ptr<std::atomic<bool>> dead_ = std::make_shared<std::atomic<bool>>(false);
    std::shared_ptr<std::atomic<bool>> cut_off_ = std::make_shared<std::atomic<bool>>(false);
    struct Outcome;
    std::shared_ptr<Outcome> outcome_;
    std::jthread thread_;
};

// Returns options of a coordinator with one core of its own.
ClusterOptions drill_options();

// Waits until so many workers take part, for at most 20 s; returns whether they do.
bool wait_for_workers(const EvaluationBackend& backend, std::size_t workers);

}  // namespace cambrian::test
