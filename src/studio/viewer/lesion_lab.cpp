#include "studio/viewer/lesion_lab.h"

#include "core/threads/thread_pool.h"
#include "evolution/backends/thread_pool_backend.h"

#include <utility>

namespace cambrian {

void LesionLab::study(const Exhibit& exhibit, bool pairs) {
    const auto task = std::make_shared<Task>();
    task->pairs = pairs;
    begin(exhibit, task);
}

void LesionLab::prune(const Exhibit& exhibit) {
    const auto task = std::make_shared<Task>();
    task->prunes = true;
    begin(exhibit, task);
}

void LesionLab::stop() {
    if (task_) task_->stop.request_stop();
    task_.reset();
}

void LesionLab::begin(const Exhibit& exhibit, const std::shared_ptr<Task>& task) {
    stop();
    task_ = task;
    worker_.submit([this, task, creature = exhibit.creature](const std::stop_token& stop) {
        return work(task, creature, stop);
    });
}

BackgroundWorker::Completion LesionLab::work(const std::shared_ptr<Task>& task,
                                             const JudgedIndividual& one,
                                             const std::stop_token& stop) {
    const std::stop_callback forward(stop, [&task] { task->stop.request_stop(); });
    const std::stop_token asked = task->stop.get_token();
    const auto backend =
        make_thread_pool_backend(kinds_, ThreadPool::default_workers(), ThreadPriority::kServing);
    const GenomePtr genome = one.individual->genome;
    const LesionStudy study{.genome = genome, .settings = *one.settings, .pairs = task->pairs};
    if (task->prunes) {
        auto twin = pruned(study, kinds_, *backend, task->progress, asked);
        return [this, task, genome, twin = std::move(twin)] {
            if (task != task_) return;
            task_.reset();
            if (twin) pruning_ = Pruning{genome, *twin};
        };
    }
    auto table = lesion_table(study, kinds_, *backend, task->progress, asked);
    return [this, task, genome, table = std::move(table)] {
        if (task != task_) return;
        task_.reset();
        studied_ = genome;
        table_ = table;
    };
}

std::optional<LesionLab::Pruning> LesionLab::update() {
    worker_.deliver();
    return std::exchange(pruning_, std::nullopt);
}

double LesionLab::share() const {
    if (!task_ || task_->progress.total == 0) return 0.0;
    return static_cast<double>(task_->progress.done) / static_cast<double>(task_->progress.total);
}

}  // namespace cambrian
