#include "studio/comparison/running_comparison.h"

#include "comparison/report.h"
#include "core/files/file_io.h"
#include "evolution/backends/thread_pool_backend.h"

#include <utility>

namespace cambrian {
RunningComparison::RunningComparison(Job job, const EvolutionKinds& kinds)
    : job_(std::move(job)),
      kinds_(kinds),
      thread_([this](const std::stop_token& stop) { work(stop); }) {}

void RunningComparison::work(const std::stop_token& stop) {
    auto opened = Comparison::open(job_.folder, job_.runs, kinds_);
    if (!opened) return publish({}, true, opened.error());
    comparison_ = *std::move(opened);
    open_.store(comparison_.get(), std::memory_order_release);
    publish(comparison_->finished(), false, {});
    Status status = perform(stop);
    const std::vector<ComparedRun> finished = comparison_->finished();
    if (status && !finished.empty())
        status = write_file(job_.folder / kReportFile, comparison_report(finished));
    publish(finished, true, status);
}

double RunningComparison::share() const {
    const Comparison* open = open_.load(std::memory_order_acquire);
    return open == nullptr ? 0.0 : open->share_done();
}

Status RunningComparison::perform(const std::stop_token& stop) {
    return comparison_->run(
        job_.threads.workers,
        [this]() -> Result<std::unique_ptr<EvaluationBackend>> {
            return make_thread_pool_backend(kinds_, 1, job_.threads.priority);
        },
        [this](const ComparedRun&) { publish(comparison_->finished(), false, {}); }, stop);
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
