#include "studio/machines/machines_controller.h"

#include "machines/scripted_cluster.h"
#include "studio_run.h"

#include <future>

namespace cambrian {
namespace {

using test::connected;
using test::ScriptedCluster;
using test::StudioRun;

const ClusterLogin kLab = {"nats://lab-server", "cambrian", "", ""};

// Joins the same cluster on every request and records the requests.
struct Lab {
    std::shared_ptr<ScriptedCluster> cluster = std::make_shared<ScriptedCluster>();
    std::shared_ptr<std::vector<std::string>> asked = std::make_shared<std::vector<std::string>>();

    MachineOptions options() const {
        return {.threads = {.workers = 2},
                .join = [cluster = cluster, asked = asked](
                            const ClusterAddress& address,
                            const ThreadShare&) -> Result<std::shared_ptr<EvaluationBackend>> {
                    asked->push_back(address.servers.front());
                    return std::shared_ptr<EvaluationBackend>(cluster);
                }};
    }
};

const MachinesView& machines_of(const StudioRun& run) {
    return *run.studio.frame_context().machines;
}

std::vector<std::uint64_t> champions_of(const StudioRun& run) {
    std::vector<std::uint64_t> digests;
    for (const JudgedIndividual& champion :
         run.studio.frame_context().experiment.snapshot.champions)
        digests.push_back(champion.individual->result.digest);
    return digests;
}

// Lets no champion be confirmed, which would go on after a generation is finished.
void confirm_nothing(StudioRun& run) {
    ExperimentSettings settings = test::small_experiment();
    settings.selection.confirmations = 0;
    run.ask(EditSettings{settings, "selection.confirmations"});
    run.ask(FinishEdit{});
}

TEST_CASE("a cluster is joined and left during a run without a change of its champions",
          "[studio][machines][threads]") {
    StudioRun alone;
    confirm_nothing(alone);
    finish_generations(alone, 6);

    const Lab lab;
    StudioRun run(lab.options());
    confirm_nothing(run);
    finish_generations(run, 2);
    CHECK(lab.cluster->batches == 0);
    run.ask(JoinCluster{kLab});
    CHECK(machines_of(run).joining);
    REQUIRE(run.frames_until([&] { return machines_of(run).joined; }));
    CHECK_FALSE(machines_of(run).joining);
    finish_generations(run, 4);
    const int evaluated = lab.cluster->batches;
    CHECK(evaluated >= 2);
    run.ask(LeaveCluster{});
    CHECK_FALSE(machines_of(run).joined);
    finish_generations(run, 6);
    CHECK(lab.cluster->batches == evaluated);
    CHECK(champions_of(run) == champions_of(alone));
    CHECK(*lab.asked == std::vector<std::string>{"nats://lab-server:4222"});
}

TEST_CASE("the reason why a cluster cannot be joined is shown, and the run continues alone",
          "[studio][machines][threads]") {
    StudioRun run(MachineOptions{.threads = {.workers = 2},
                                 .join = [](const ClusterAddress& address, const ThreadShare&)
                                     -> Result<std::shared_ptr<EvaluationBackend>> {
                                     return Error{address.servers.front() + " cannot be reached"};
                                 }});
    run.ask(JoinCluster{kLab});
    REQUIRE(run.frames_until([&] { return !machines_of(run).joining; }));
    CHECK_FALSE(machines_of(run).joined);
    CHECK(machines_of(run).problem == "nats://lab-server:4222 cannot be reached");
    REQUIRE(run.frames_until([&] { return run.studio.feedback().notice() != nullptr; }));
    CHECK(run.studio.feedback().notice()->text.find("nats://lab-server:4222 cannot be reached") !=
          std::string::npos);
    finish_generations(run, 1);
    run.ask(LeaveCluster{});
    CHECK(machines_of(run).problem.empty());
}

TEST_CASE("an invalid address is reported before any connection", "[studio][machines][threads]") {
    for (const char* servers : {"http://lab", "nats://me:secret@lab", "tls://a,nats://b"}) {
        const Lab lab;
        StudioRun run(lab.options());
        run.ask(JoinCluster{{servers, "", "", ""}});
        REQUIRE(run.frames_until([&] { return !machines_of(run).joining; }));
        CHECK_FALSE(machines_of(run).joined);
        CHECK(machines_of(run).problem == cluster_address({servers, "", "", ""}).error().message);
        CHECK(lab.asked->empty());
    }
}

TEST_CASE("joining over an unencrypted connection shows a warning", "[studio][machines][threads]") {
    const std::pair<const char*, bool> cases[] = {
        {"nats://lab-server", true}, {"tls://lab-server", false}, {"nats://localhost", false}};
    for (const auto& [servers, readable] : cases) {
        const Lab lab;
        StudioRun run(lab.options());
        run.ask(JoinCluster{{servers, "", "", ""}});
        REQUIRE(run.frames_until([&] { return machines_of(run).joined; }));
        run.studio.update(21.0, 0.001);
        const Notice* notice = run.studio.feedback().notice();
        CHECK((notice != nullptr && notice->text.find("readable") != std::string::npos) ==
              readable);
    }
}

TEST_CASE("an attempt to join that was cancelled has no effect when it ends",
          "[studio][machines][threads]") {
    std::promise<void> answered;
    const auto cluster = std::make_shared<ScriptedCluster>();
    StudioRun run(MachineOptions{.threads = {.workers = 2},
                                 .join = [&, answer = answered.get_future().share()](
                                             const ClusterAddress&, const ThreadShare&)
                                     -> Result<std::shared_ptr<EvaluationBackend>> {
                                     answer.wait();
                                     return std::shared_ptr<EvaluationBackend>(cluster);
                                 }});
    run.ask(JoinCluster{kLab});
    run.ask(LeaveCluster{});
    answered.set_value();
    finish_generations(run, 1);
    CHECK_FALSE(machines_of(run).joined);
    CHECK(cluster->batches == 0);
    CHECK(run.log().find("cluster joined") == std::string::npos);
}

TEST_CASE("the stored cluster is joined at the start if it was joined at the end",
          "[studio][machines][threads]") {
    for (const bool joined : {true, false}) {
        const Lab lab;
        StudioRun run(lab.options(), {kLab, joined});
        run.frames_until([&] { return machines_of(run).joined || !joined; });
        CHECK(machines_of(run).joined == joined);
        CHECK(machines_of(run).login == kLab);
        CHECK(run.studio.machines().memory() == ClusterMemory{kLab, joined});
    }
    const Lab lab;
    MachineOptions options = lab.options();
    options.cluster = ClusterLogin{"nats://other", "second", "", ""};
    StudioRun run(options, {kLab, true});
    REQUIRE(run.frames_until([&] { return machines_of(run).joined; }));
    CHECK(*lab.asked == std::vector<std::string>{"nats://other:4222"});
}

TEST_CASE("losing and finding a cluster again are both reported", "[studio][machines][threads]") {
    const Lab lab;
    lab.cluster->say(connected(3));
    StudioRun run(lab.options());
    run.ask(JoinCluster{kLab});
    const auto link = [&] { return machines_of(run).status.link; };
    REQUIRE(run.frames_until([&] { return link() == ClusterLink::kConnected; }));
    CHECK(totals(machines_of(run).status).cores == 24);
    BackendStatus away = connected(1);
    away.link = ClusterLink::kAway;
    lab.cluster->say(away);
    REQUIRE(run.frames_until([&] { return link() == ClusterLink::kAway; }));
    REQUIRE(run.frames_until([&] { return run.studio.feedback().notice() != nullptr; }));
    CHECK(run.studio.feedback().notice()->text.find("working alone") != std::string::npos);
    lab.cluster->say(connected(3));
    REQUIRE(run.frames_until([&] {
        const Notice* notice = run.studio.feedback().notice();
        return notice != nullptr && notice->text == "The cluster is back.";
    }));
    CHECK(run.log().find("\"link\":\"away\"") != std::string::npos);
}

}  // namespace
}  // namespace cambrian
