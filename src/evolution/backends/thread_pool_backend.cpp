#include "evolution/backends/thread_pool_backend.h"

#include "core/threads/thread_pool.h"
#include "evolution/longest_first.h"
#include "evolution/trials.h"

#include <vector>

namespace cambrian {
namespace {

class ThreadPoolBackend final : public EvaluationBackend {
public:
    ThreadPoolBackend(const EvolutionKinds& kinds, std::size_t workers, ThreadPriority priority)
        : kinds_(kinds), pool_(workers, priority) {}

    bool evaluate(std::span<const EvaluationRequest> requests,
                  std::span<std::optional<EvaluationResult>> results,
                  const ExperimentSettings& settings, EvaluationProgress& progress,
                  std::stop_token stop) override {
        std::vector<std::size_t> open;
        for (std::size_t i = 0; i < requests.size(); ++i) {
            if (!results[i]) open.push_back(i);
        }
        put_longest_first(open, requests);
        progress.done = static_cast<std::uint32_t>(requests.size() - open.size());
        progress.total = static_cast<std::uint32_t>(requests.size());
        return pool_.parallel_for(
            open.size(),
            [&](std::size_t index, std::size_t) {
                EvaluationResult result =
                    evaluate_in_trials(requests[open[index]], settings, kinds_, stop);
                if (result.outcome == Outcome::kInterrupted) return;
                results[open[index]] = std::move(result);
                progress.done.fetch_add(1, std::memory_order_relaxed);
            },
            stop);
    }

private:
    const EvolutionKinds& kinds_;
    ThreadPool pool_;
};

}  // namespace

std::unique_ptr<EvaluationBackend> make_thread_pool_backend(const EvolutionKinds& kinds,
                                                            std::size_t workers,
                                                            ThreadPriority priority) {
    return std::make_unique<ThreadPoolBackend>(kinds, workers, priority);
}

}  // namespace cambrian
