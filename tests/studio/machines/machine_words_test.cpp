#include "studio/machines/machine_words.h"

#include "machines/scripted_cluster.h"
#include "support/catch.h"

namespace cambrian {
namespace {

MachinesView joined(BackendStatus status) {
    MachinesView machines;
    machines.login.servers = "nats://lab-server";
    machines.joined = true;
    machines.status = std::move(status);
    return machines;
}

TEST_CASE("a worker's state is described in words", "[studio][machines]") {
    WorkerStatus worker;
    worker.state = WorkerState::kWorking;
    CHECK(state_words(worker) == "working");
    worker.state = WorkerState::kIdle;
    CHECK(state_words(worker) == "idle");
    worker.state = WorkerState::kAway;
    worker.silent_seconds = 12.4;
    CHECK(state_words(worker) == "away 12 s");
    worker.state = WorkerState::kRefused;
    CHECK(state_words(worker) == "refused");
    worker.refusal = "other bits";
    CHECK(state_words(worker) == "refused: other bits");
}

TEST_CASE("the line of machines counts those that evaluate", "[studio][machines]") {
    BackendStatus status = test::connected(14);
    CHECK(machines_words(joined(status)) == "14 machines · 112 cores · 9 800 creatures/s");
    status.workers.back().state = WorkerState::kAway;
    status.useful_cores = 37.6;
    CHECK(machines_words(joined(status)) ==
          "13 machines · 104 cores · 9 100 creatures/s · This run can use about 38 cores");
    status = test::connected(1);
    status.workers.back().cores = 1;
    CHECK(totals_words(status) == "1 machine · 1 core · 700 creatures/s");
    CHECK_FALSE(troubled(joined(status)));
}

TEST_CASE("a problem with the cluster replaces the count of machines", "[studio][machines]") {
    MachinesView machines;
    CHECK_FALSE(cluster_wanted(machines));
    machines.login.servers = "nats://lab-server";
    machines.joining = true;
    CHECK(machines_words(machines) == "Reaching nats://lab-server…");
    CHECK_FALSE(troubled(machines));
    machines.joining = false;
    machines.problem = "no such host: lab-server";
    CHECK(machines_words(machines) == "Working alone: no such host: lab-server");
    CHECK(cluster_wanted(machines));
    CHECK(troubled(machines));

    BackendStatus status = test::connected(2);
    status.link = ClusterLink::kAway;
    CHECK(machines_words(joined(status)) == "Cluster away, working alone");
    status.trouble = "the connection was lost";
    CHECK(machines_words(joined(status)) == "Cluster away, working alone: the connection was lost");
    CHECK(troubled(joined(status)));
    status.link = ClusterLink::kConnecting;
    status.trouble.clear();
    CHECK(machines_words(joined(status)) == "Working alone until nats://lab-server answers");
    status.link = ClusterLink::kConnected;
    status.failure = "two workers gave other bits";
    CHECK(machines_words(joined(status)) == "two workers gave other bits");
    CHECK(troubled(joined(status)));
}

}  // namespace
}  // namespace cambrian
