#pragma once

// A run over a cluster whose server is in memory and whose workers are threads, any of which can be
// made to vanish. Its digests are compared with those of the same run on one thread of one machine.

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

// 12 generations of 60 creatures that walk for a few seconds.
ExperimentSettings drill_settings();

// Of each generation.
using Digests = std::vector<std::uint64_t>;
Digests local_digests(const ExperimentSettings& settings);

// The digests of that run with another back-end; fewer if an evaluation fails. between: called
// before each generation with its number.
Digests digests_of_run(const ExperimentSettings& settings, EvaluationBackend& backend,
                       const std::function<void(int)>& between = {});

struct WorkerHabits {
    // Whether it vanishes with this unit in hand, as a process that is killed does.
    std::function<bool(const UnitMessage&)> dies_of;
    // Before a result is published.
    std::function<void(UnitMessage&)> changes;
    std::chrono::milliseconds slow{0};  // a unit
};

class DrillWorker {
public:
    DrillWorker(MemoryServer& server, std::uint64_t id, WorkerHabits habits = {});
    ~DrillWorker();

    // Vanishes without another word.
    void kill();
    bool dead() const { return *dead_; }
    // Its messages do not come through, and come through again.
    void cut_off(bool off) { *cut_off_ = off; }
    // How it ended: empty, or why a coordinator refused it. Waits for its end, 20 s at most.
    std::string end();
    std::vector<std::string> said() const;

private:
    std::shared_ptr<std::atomic<bool>> dead_ = std::make_shared<std::atomic<bool>>(false);
    std::shared_ptr<std::atomic<bool>> cut_off_ = std::make_shared<std::atomic<bool>>(false);
    struct Outcome;
    std::shared_ptr<Outcome> outcome_;
    std::jthread thread_;
};

// Of a coordinator with one own core.
ClusterOptions drill_options();

// Waits until so many workers take part, 20 s at most; whether they do.
bool wait_for_workers(const EvaluationBackend& backend, std::size_t workers);

}  // namespace cambrian::test
