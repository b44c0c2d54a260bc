#include "studio/comparison/running_comparison.h"

#include "comparison/report.h"
#include "core/files/file_io.h"
#include "evolution/backends/thread_pool_backend.h"

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <utility>

namespace cambrian {
namespace {

constexpr const char* kReport = "report.md";
constexpr std::chrono::milliseconds kShareInterval{200};

// Tells the share that is done, again and again, until it is destroyed.
class ShareTeller {
public:
    ShareTeller(const Comparison& comparison, std::atomic<double>& share)
        : thread_([&comparison, &share, this](const std::stop_token& stop) {
              std::unique_lock<std::mutex> lock(mutex_);
              while (!stop.stop_requested()) {
                  share.store(comparison.share_done(), std::memory_order_relaxed);
                  changed_.wait_for(lock, stop, kShareInterval, [] { return false; });
              }
          }) {}

private:
    std::mutex mutex_;
    std::condition_variable_any changed_;
    std::jthread thread_;  // last member
};

}  // namespace

RunningComparison::RunningComparison(Job job, const EvolutionKinds& kinds)
    : job_(std::move(job)),
      kinds_(kinds),
      thread_([this](const std::stop_token& stop) { work(stop); }) {}

void RunningComparison::work(const std::stop_token& stop) {
    const auto comparison = Comparison::open(job_.folder, job_.runs, kinds_);
    if (!comparison) return publish({}, true, comparison.error());
    publish((*comparison)->finished(), false, {});
    Status status = perform(**comparison, stop);
    const std::vector<ComparedRun> finished = (*comparison)->finished();
    if (status && !finished.empty())
        status = write_file(job_.folder / kReport, comparison_report(finished));
    share_.store((*comparison)->share_done(), std::memory_order_relaxed);
    publish(finished, true, status);
}

Status RunningComparison::perform(Comparison& comparison, const std::stop_token& stop) {
    if (comparison.missing() == 0) return {};
    const ShareTeller teller(comparison, share_);
    return comparison.run(
        job_.at_a_time,
        [this]() -> Result<std::unique_ptr<EvaluationBackend>> {
            return make_thread_pool_backend(kinds_, 1, ThreadPriority::kBackground);
        },
        [&](const ComparedRun&) { publish(comparison.finished(), false, {}); }, stop);
}

void RunningComparison::publish(const std::vector<ComparedRun>& finished, bool ended,
                                const Status& status) {
    auto results = std::make_shared<ComparisonResults>(
        results_of(job_.arms, job_.runs.size() / job_.arms.size(), finished, job_.folder));
    results->ended = ended;
    if (!status) results->problem = status.error().message;
    channel_.publish(std::move(results));
}

}  // namespace cambrian
