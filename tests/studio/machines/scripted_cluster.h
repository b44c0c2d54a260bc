#pragma once

// A cluster for the studio that evaluates on two threads of this machine and counts its
// evaluations. Tests set the status it reports.

#include "evolution/backends/thread_pool_backend.h"
#include "support/kinds.h"

#include <atomic>
#include <memory>
#include <mutex>
#include <utility>

namespace cambrian::test {

class ScriptedCluster final : public EvaluationBackend {
public:
    bool evaluate(std::span<const EvaluationRequest> requests,
                  std::span<std::optional<EvaluationResult>> results,
                  const ExperimentSettings& settings, EvaluationProgress& progress,
                  std::stop_token stop) override {
        batches += 1;
        return cores_->evaluate(requests, results, settings, progress, std::move(stop));
    }
    BackendStatus status() const override {
        const std::lock_guard lock(mutex_);
        return status_;
    }
    void say(BackendStatus status) {
        const std::lock_guard lock(mutex_);
        status_ = std::move(status);
    }

    std::atomic<int> batches = 0;

private:
    std::unique_ptr<EvaluationBackend> cores_ = make_thread_pool_backend(kinds(), 2);
    mutable std::mutex mutex_;
    BackendStatus status_;
};

// Returns the status of a cluster with so many working machines of eight cores.
inline BackendStatus connected(int machines) {
    BackendStatus status;
    status.link = ClusterLink::kConnected;
    for (int i = 0; i < machines; ++i) {
        WorkerStatus worker;
        worker.id = std::to_string(i);
        worker.name = "lab-" + std::to_string(i);
        worker.cores = 8;
        worker.state = WorkerState::kWorking;
        worker.creatures_per_second = 700.0;
        worker.share = 1.0 / machines;
        worker.checks_passed = 12;
        status.workers.push_back(std::move(worker));
    }
    return status;
}

}  // namespace cambrian::test
