#include "evolution/evaluation/backend_status.h"

#include "evolution/backends/thread_pool_backend.h"
#include "evolution/evolution.h"
#include "support/catch.h"
#include "support/kinds.h"

#include <atomic>
#include <memory>
#include <thread>

using namespace cambrian;

namespace {

WorkerStatus worker(WorkerState state, std::uint32_t cores, double rate) {
    WorkerStatus status;
    status.state = state;
    status.cores = cores;
    status.creatures_per_second = rate;
    return status;
}

}  // namespace

TEST_CASE("Totals leave out workers that are away or refused", "[evolution][backend]") {
    BackendStatus status;
    status.workers = {worker(WorkerState::kWorking, 2, 40.0), worker(WorkerState::kIdle, 8, 0.0),
                      worker(WorkerState::kAway, 16, 100.0),
                      worker(WorkerState::kRefused, 32, 200.0)};
    CHECK(totals(status).machines == 2);
    CHECK(totals(status).cores == 10);
    CHECK(totals(status).creatures_per_second == 40.0);
}

TEST_CASE("A generation uses as many cores as leave it a quarter of its time to wait",
          "[evolution][backend]") {
    for (const double overhead : {0.032, 0.120}) {
        const double cores = useful_cores(80.0, overhead);
        const double evaluating = 80.0 / cores;
        CHECK(overhead / (evaluating + overhead) == Approx(0.25));
    }
    CHECK(useful_cores(1e-6, 10.0) == 1.0);
}

TEST_CASE("The thread pool's status is one row, working while it evaluates",
          "[evolution][backend][threads]") {
    auto backend = make_thread_pool_backend(test::kinds(), 2);
    REQUIRE(backend->status().workers.size() == 1);
    CHECK(backend->status().link == ClusterLink::kNone);
    const WorkerStatus before = backend->status().workers.front();
    CHECK(before.cores == 2);
    CHECK(before.state == WorkerState::kIdle);
    CHECK(before.creatures_per_second == 0.0);
    CHECK(before.share == 0.0);

    ExperimentSettings settings;
    settings.population.size = 40;
    Evolution evolution(std::make_shared<const ExperimentSettings>(settings), test::kinds());
    EvaluationProgress progress;
    std::atomic<bool> seen_working = false;
    std::jthread watcher([&](const std::stop_token& stop) {
        while (!stop.stop_requested() && !seen_working) {
            seen_working = backend->status().workers.front().state == WorkerState::kWorking;
            std::this_thread::yield();
        }
    });
    for (int generation = 0; generation < 100 && !seen_working; ++generation) {
        REQUIRE(evolution.evaluate(*backend, progress, {}));
        evolution.breed();
    }
    CHECK(seen_working);
    const WorkerStatus after = backend->status().workers.front();
    CHECK(after.state == WorkerState::kIdle);
    CHECK(after.creatures_per_second > 0.0);
    CHECK(after.share == 1.0);
}
