#include "evolution/backends/thread_pool_backend.h"

#include "core/recent_sum.h"
#include "core/stopwatch.h"
#include "core/threads/thread_pool.h"
#include "evolution/evaluation/longest_first.h"
#include "evolution/evaluation/trials.h"

#include <atomic>
#include <mutex>
#include <utility>
#include <vector>

namespace cambrian {
namespace {

constexpr int kRateSeconds = 5;  // s; interval over which a rate is averaged

class ThreadPoolBackend final : public EvaluationBackend {
public:
    ThreadPoolBackend(const EvolutionKinds& kinds, std::size_t workers, ThreadPriority priority)
        : kinds_(kinds), pool_(workers, priority) {}

    bool evaluate(std::span<const EvaluationRequest> requests,
                  std::span<std::optional<EvaluationResult>> results,
                  const ExperimentSettings& settings, EvaluationProgress& progress,
                  std::stop_token stop) override {
        const std::vector<std::size_t> open = open_longest_first(requests, results);
        progress.done = static_cast<std::uint32_t>(requests.size() - open.size());
        progress.total = static_cast<std::uint32_t>(requests.size());
        const Busy busy(evaluating_);
        return pool_.parallel_for(
            open.size(),
            [&](std::size_t index, std::size_t) {
                EvaluationResult result =
                    evaluate_in_trials(requests[open[index]], settings, kinds_, stop);
                if (result.outcome == Outcome::kInterrupted) return;
                results[open[index]] = std::move(result);
                count_creature();
                progress.done.fetch_add(1, std::memory_order_relaxed);
            },
            stop);
    }

    BackendStatus status() const override {
        WorkerStatus own;
        own.name = "this machine";
        own.cores = static_cast<std::uint32_t>(pool_.workers());
        own.state = evaluating_ ? WorkerState::kWorking : WorkerState::kIdle;
        const std::lock_guard lock(creatures_mutex_);
        const double now = clock_.seconds();
        own.creatures_per_second = creatures_.rate(now, kRateSeconds);
        own.share = creatures_.sum(now) > 0.0 ? 1.0 : 0.0;
        BackendStatus status;
        status.workers.push_back(std::move(own));
        return status;
    }

private:
    // Sets a flag during its lifetime, while a batch runs.
    class Busy {
    public:
        explicit Busy(std::atomic<bool>& flag) : flag_(flag) { flag_ = true; }
        ~Busy() { flag_ = false; }
        Busy(const Busy&) = delete;
        Busy& operator=(const Busy&) = delete;

    private:
        std::atomic<bool>& flag_;
    };

    void count_creature() {
        const std::lock_guard lock(creatures_mutex_);
        creatures_.add(1.0, clock_.seconds());
    }

    const EvolutionKinds& kinds_;
    ThreadPool pool_;
    std::atomic<bool> evaluating_ = false;
    const Stopwatch clock_;
    mutable std::mutex creatures_mutex_;
    RecentSum creatures_;  // creatures evaluated; guarded by creatures_mutex_
};

}  // namespace

std::unique_ptr<EvaluationBackend> make_thread_pool_backend(const EvolutionKinds& kinds,
                                                            std::size_t workers,
                                                            ThreadPriority priority) {
    return std::make_unique<ThreadPoolBackend>(kinds, workers, priority);
}

}  // namespace cambrian
