#include "cluster/drill.h"

#include "core/random.h"
#include "evolution/backends/thread_pool_backend.h"
#include "evolution/evolution.h"
#include "evolution/individual/population_digest.h"
#include "support/build_speed.h"
#include "support/kinds.h"

#include <map>
#include <mutex>
#include <utility>

namespace cambrian::test {
namespace {

using std::chrono::milliseconds;

// A queue between a worker and the real one, which can disappear.
class MortalQueue final : public WorkerQueue {
public:
    using Flag = std::shared_ptr<std::atomic<bool>>;
    MortalQueue(std::unique_ptr<WorkerQueue> inner, Flag dead, Flag cut_off, WorkerHabits habits)
        : inner_(std::move(inner)),
          dead_(std::move(dead)),
          cut_off_(std::move(cut_off)),
          habits_(std::move(habits)) {}

    bool connected() const override { return !gone() && inner_->connected(); }
    std::vector<Delivery> fetch(std::size_t most, milliseconds longest) override {
        if (gone()) {
            std::this_thread::sleep_for(milliseconds(2));
            return {};
        }
        std::vector<Delivery> deliveries = inner_->fetch(most, longest);
        for (const Delivery& delivery : deliveries) {
            if (habits_.dies_of && habits_.dies_of(delivery.unit)) *dead_ = true;
        }
        if (gone()) deliveries.clear();
        return deliveries;
    }
    void in_progress(std::uint64_t ticket) override {
        if (!gone()) inner_->in_progress(ticket);
    }
    void acknowledge(std::uint64_t ticket) override {
        if (!gone()) inner_->acknowledge(ticket);
    }
    void give_back(std::uint64_t ticket, milliseconds delay) override {
        if (!gone()) inner_->give_back(ticket, delay);
    }
    void discard(std::uint64_t ticket) override {
        if (!gone()) inner_->discard(ticket);
    }
    bool publish_result(const UnitMessage& result) override {
        for (milliseconds slept{0}; slept < habits_.slow && !*dead_; slept += milliseconds(5))
            std::this_thread::sleep_for(milliseconds(5));
        if (*dead_) return true;  // no worker is left to repeat it
        if (*cut_off_) return false;
        UnitMessage message = result;
        if (habits_.changes) habits_.changes(message);
        return inner_->publish_result(message);
    }
    FetchedSettings fetch_settings(std::string_view key) override {
        return gone() ? FetchedSettings{} : inner_->fetch_settings(key);
    }
    WorkerNews poll() override { return gone() ? WorkerNews{} : inner_->poll(); }
    void say_hello(std::string_view sender, std::string_view text) override {
        if (!gone()) inner_->say_hello(sender, text);
    }

private:
    bool gone() const { return *dead_ || *cut_off_; }

    std::unique_ptr<WorkerQueue> inner_;
    Flag dead_;
    Flag cut_off_;
    WorkerHabits habits_;
};

constexpr double kDuration = by_build(2.0, 0.6);  // s of a trial

}  // namespace

ExperimentSettings drill_settings() {
    ExperimentSettings settings;
    settings.seed = 7;
    settings.population.size = by_build(60, 30);
    settings.generations = 12;
    settings.world.environment = kinds().goals.find(settings.goal)->default_environment();
    settings.world.trial.duration = kDuration;
    return settings;
}

Digests digests_of_run(const ExperimentSettings& settings, EvaluationBackend& backend,
                       const std::function<void(int)>& between) {
    Evolution evolution(std::make_shared<const ExperimentSettings>(settings), kinds());
    EvaluationProgress progress;
    Digests digests;
    for (int generation = 0; generation < settings.generations; ++generation) {
        if (generation > 0) evolution.breed();
        if (between) between(generation);
        if (!evolution.evaluate(backend, progress, {})) break;
        digests.push_back(population_digest(evolution.population()));
    }
    return digests;
}

Digests local_digests(const ExperimentSettings& settings) {
    const auto backend = make_thread_pool_backend(kinds(), 1);
    return digests_of_run(settings, *backend);
}

struct DrillWorker::Outcome {
    std::mutex mutex;
    std::vector<std::string> said;
};

DrillWorker::DrillWorker(MemoryServer& server, std::uint64_t id, WorkerHabits habits)
    : outcome_(std::make_shared<Outcome>()) {
    std::shared_ptr<WorkerQueue> queue = std::make_shared<MortalQueue>(
        server.worker(habits.login), dead_, cut_off_, std::move(habits));
    thread_ = std::jthread([queue, id, outcome = outcome_](const std::stop_token& stop) {
        WorkerOptions options;
        options.id = id;
        options.name = "worker " + std::to_string(id);
        options.threads.priority = ThreadPriority::kNormal;
        options.say = [outcome](std::string_view line) {
            const std::lock_guard lock(outcome->mutex);
            outcome->said.emplace_back(line);
        };
        work_for_cluster(kinds(), *queue, options, stop);
    });
}

DrillWorker::~DrillWorker() = default;

void DrillWorker::kill() {
    *dead_ = true;
    thread_.request_stop();
}

std::vector<std::string> DrillWorker::said() const {
    const std::lock_guard lock(outcome_->mutex);
    return outcome_->said;
}

ClusterOptions drill_options() {
    ClusterOptions options;
    options.threads.workers = 1;
    options.name = "here";
    options.run = 0x1234;
    options.secret = 99;
    return options;
}

bool wait_for_workers(const EvaluationBackend& backend, std::size_t workers) {
    for (int tried = 0; tried < 2'000; ++tried) {
        if (totals(backend.status()).machines == workers + 1) return true;
        std::this_thread::sleep_for(milliseconds(10));
    }
    return false;
}

}  // namespace cambrian::test
