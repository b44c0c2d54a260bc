// Runs with every kind of failure end with the digests of the run on one machine.

#include "cluster/bit_flipper.h"
#include "cluster/drill.h"
#include "cluster/messages/hello_text.h"
#include "cluster/messages/result_text.h"
#include "cluster/messages/unit_text.h"
#include "core/random.h"
#include "evolution/evolution.h"
#include "evolution/individual/population_digest.h"
#include "evolution/settings/goal_defaults.h"
#include "persist/creature/creature_file.h"
#include "persist/text/digest_text.h"
#include "simulator/simulator_version.h"
#include "support/catch.h"
#include "support/kinds.h"
#include "support/temporary_directory.h"

#include <atomic>
#include <mutex>

using namespace cambrian;
using namespace cambrian::test;
using std::chrono::milliseconds;

namespace {

const Digests& expected() {
    static const Digests digests = local_digests(drill_settings());
    return digests;
}

struct Cluster {
    explicit Cluster(std::size_t count, const Faults& faults = {},
                     ClusterOptions options = drill_options())
        : server(faults),
          backend(make_cluster_backend(kinds(), server.coordinator(), std::move(options))) {
        for (std::size_t i = 0; i < count; ++i)
            add_worker();
        REQUIRE(wait_for_workers(*backend, count));
    }
    DrillWorker& add_worker(WorkerHabits habits = {}) {
        workers.push_back(
            std::make_unique<DrillWorker>(server, 100 + workers.size(), std::move(habits)));
        return *workers.back();
    }
    Digests run(const std::function<void(int)>& between = {}) {
        return digests_of_run(drill_settings(), *backend, between);
    }
    BackendCounts counts() const { return backend->status().counts; }

    MemoryServer server;
    std::unique_ptr<EvaluationBackend> backend;
    std::vector<std::unique_ptr<DrillWorker>> workers;
};

// Gives every result of a unit another bit.
void spoil(UnitMessage& message) {
    UnitResult unit = *parse_unit_result(message.body);
    for (SlotResult& each : unit.results)
        each.result.digest ^= 1U;
    message.body = write_unit_result(unit);
}

// Waits for a line of a worker, for at most 20 s.
bool comes_to_say(const DrillWorker& worker, const std::string& words) {
    for (int tried = 0; tried < 2'000; ++tried) {
        for (const std::string& line : worker.said()) {
            if (line.find(words) != std::string::npos) return true;
        }
        std::this_thread::sleep_for(milliseconds(10));
    }
    return false;
}

}  // namespace

TEST_CASE("any number of workers gives the bits of one machine", "[cluster][threads]") {
    const std::size_t count = GENERATE(0U, 1U, 2U, 7U);
    Cluster cluster(count);
    CHECK(cluster.run() == expected());
    const BackendStatus status = cluster.backend->status();
    CHECK((status.counts.units > 0) == (count > 0));
    CHECK(status.counts.refused == 0);
    CHECK(status.counts.malformed == 0);
    double shares = 0.0;
    for (const WorkerStatus& worker : status.workers)
        shares += worker.share;
    CHECK(shares == Approx(1.0));
    if (count > 0) CHECK(status.workers.front().share < 1.0);
}

TEST_CASE("several trials, probes and early-termination thresholds are transferred",
          "[cluster][threads]") {
    ExperimentSettings settings = drill_settings();
    settings.generations = 6;
    settings.terminate_early = true;  // has an effect with one trial only
    settings.world.trial.trials = GENERATE(1, 3);
    settings.world.trial.friction_jitter = 0.2;
    settings.world.trial.tilt_jitter = 5.0;
    settings.world.trial.combine = GENERATE("mean", "minimum");
    settings.selection.confirm_jitter = 0.03;
    Cluster cluster(2);
    CHECK(digests_of_run(settings, *cluster.backend) == local_digests(settings));
    CHECK(cluster.counts().units > 0);
    CHECK(cluster.counts().refused == 0);
}

TEST_CASE("workers judge a contest against the opponents of each generation",
          "[cluster][threads]") {
    ExperimentSettings settings = drill_settings();
    settings.goal = "competition";
    settings.generations = 4;
    settings.population.size = 24;
    adopt_defaults(settings, *kinds().goals.find(settings.goal));
    settings.world.trial.duration = 1.0;
    Cluster cluster(2);
    CHECK(digests_of_run(settings, *cluster.backend) == local_digests(settings));
    CHECK(cluster.counts().units > 0);
    CHECK(cluster.counts().refused == 0);
}

TEST_CASE("a queue that loses, delays, repeats and reorders changes no bit", "[cluster][threads]") {
    Faults faults;
    faults.seed = GENERATE(1U, 2U);
    faults.lost_delivery = 0.1;
    faults.repeated_delivery = 0.2;
    faults.lost_result = 0.1;
    faults.repeated_result = 0.3;
    faults.reorders = true;
    faults.longest_delay = milliseconds(30);
    Cluster cluster(2, faults);
    CHECK(cluster.run() == expected());
    CHECK(cluster.counts().duplicates > 0);
    CHECK(cluster.counts().overdue_at_home > 0);
    CHECK(cluster.counts().refused == 0);
}

TEST_CASE("workers that are killed cost no bit", "[cluster][threads]") {
    Cluster cluster(3);
    const auto kill_one = [&](int generation) {
        if (generation % 3 != 1) return;
        cluster.workers[static_cast<std::size_t>(generation / 3)]->kill();
        cluster.add_worker();
    };
    CHECK(cluster.run(kill_one) == expected());
    // No creature is evaluated endlessly: a unit is delivered at most five times.
    CHECK(cluster.server.deliveries() <= 5 * cluster.counts().units);
}

TEST_CASE("with all workers killed in mid-generation the run goes on alone", "[cluster][threads]") {
    int units = 0;
    Cluster cluster(0);
    const auto third = [&units](const UnitMessage&) { return ++units == 3; };
    cluster.add_worker({.dies_of = third, .changes = {}});
    REQUIRE(wait_for_workers(*cluster.backend, 1));
    CHECK(cluster.run() == expected());
    CHECK(cluster.workers.front()->dead());
    CHECK(cluster.counts().overdue_at_home > 0);
}

TEST_CASE("a server that goes away and comes back is used again", "[cluster][threads]") {
    Cluster cluster(2);
    std::uint64_t units_before = 0;
    std::uint64_t units_while_away = 0;
    const auto restart = [&](int generation) {
        if (generation == 4) {
            cluster.server.set_running(false);
            REQUIRE(wait_for_workers(*cluster.backend, 0));
            CHECK(cluster.backend->status().link == ClusterLink::kAway);
            units_before = cluster.counts().units;
        }
        if (generation == 8) {
            units_while_away = cluster.counts().units - units_before;
            cluster.server.set_running(true);
            REQUIRE(wait_for_workers(*cluster.backend, 2));
            CHECK(cluster.backend->status().link == ClusterLink::kConnected);
        }
    };
    CHECK(cluster.run(restart) == expected());
    CHECK(units_before > 0);
    CHECK(units_while_away == 0);
    CHECK(cluster.counts().units > units_before);
}

TEST_CASE("a server that stops in mid-generation does not delay the run", "[cluster][threads]") {
    int units = 0;  // outlives the workers that count it
    Cluster cluster(0);
    const auto stop_server = [&](UnitMessage&) {
        if (++units == 4) cluster.server.set_running(false);
    };
    cluster.add_worker({.dies_of = {}, .changes = stop_server});
    REQUIRE(wait_for_workers(*cluster.backend, 1));
    CHECK(cluster.run() == expected());
    CHECK(cluster.counts().overdue_at_home > 0);
}

TEST_CASE("late results of a worker that was cut off are compared and dropped",
          "[cluster][threads]") {
    Cluster cluster(2);
    const auto cut = [&](int generation) {
        if (generation == 3) cluster.workers.front()->cut_off(true);
        if (generation == 6) cluster.workers.front()->cut_off(false);
    };
    CHECK(cluster.run(cut) == expected());
    CHECK(cluster.counts().refused == 0);
}

TEST_CASE("a slow worker holds up a generation little", "[cluster][threads]") {
    Faults patient;
    patient.patience = milliseconds(60'000);
    Cluster cluster(1, patient);
    cluster.add_worker({.dies_of = {}, .changes = {}, .slow = milliseconds(20'000)});
    REQUIRE(wait_for_workers(*cluster.backend, 2));
    CHECK(cluster.run() == expected());
    CHECK(cluster.counts().overdue_at_home > 0);
    // Its results never arrive: it sleeps for longer than the run takes.
    for (const WorkerStatus& worker : cluster.backend->status().workers) {
        if (worker.name == "worker 101") CHECK(worker.share == 0.0);
    }
    cluster.workers.back()->kill();
}

TEST_CASE("a worker that flips a bit of a result is refused", "[cluster][threads]") {
    BitFlipper flipper;
    Cluster cluster(1);
    const auto flip = [&](UnitMessage& message) { flipper.change(message); };
    DrillWorker& faulty = cluster.add_worker({.dies_of = {}, .changes = flip});
    REQUIRE(wait_for_workers(*cluster.backend, 2));
    int refused_at = -1;
    const auto watch = [&](int generation) {
        for (const WorkerStatus& worker : cluster.backend->status().workers) {
            if (worker.state != WorkerState::kRefused || refused_at >= 0) continue;
            CHECK(worker.name == "worker 101");
            CHECK(worker.refusal == "a result differed from that of the coordinator");
            refused_at = generation;
        }
    };
    CHECK(cluster.run(watch) == expected());
    watch(drill_settings().generations);
    CHECK(refused_at >= 0);
    CHECK(comes_to_say(faulty, "refuses this worker: a result differed"));
}

TEST_CASE("two workers that differ end the run if they have two logins", "[cluster][threads]") {
    Cluster cluster(0);
    const std::string other = GENERATE("lab", "other");
    cluster.add_worker({.dies_of = {}, .changes = spoil});
    cluster.add_worker({.dies_of = {}, .changes = spoil, .login = other});
    REQUIRE(wait_for_workers(*cluster.backend, 2));
    const Digests digests = cluster.run();
    const BackendStatus status = cluster.backend->status();
    if (other == "lab") {
        // One login may invent any number of workers.
        CHECK(digests == expected());
        CHECK(status.failure.empty());
        CHECK(status.trouble.find("workers with the login lab differed") != std::string::npos);
    } else {
        CHECK(digests.size() < expected().size());
        CHECK(status.failure.find("two workers") != std::string::npos);
    }
}

TEST_CASE("results under invented ids count for nothing", "[cluster][threads]") {
    std::uint64_t invented = 0xdead'0000;
    Cluster cluster(1);
    const auto invent = [&](UnitMessage& message) {
        spoil(message);
        UnitResult unit = *parse_unit_result(message.body);
        unit.worker = ++invented;
        message.body = write_unit_result(unit);
    };
    cluster.add_worker({.dies_of = {}, .changes = invent});
    REQUIRE(wait_for_workers(*cluster.backend, 2));
    CHECK(cluster.run() == expected());
    CHECK(cluster.counts().unknown > 0);
    CHECK(cluster.counts().refused == 0);
    CHECK(cluster.backend->status().failure.empty());
}

TEST_CASE("nobody speaks for a worker of another login", "[cluster][threads]") {
    Cluster cluster(1);
    const auto pretend = [&](UnitMessage& message) {
        spoil(message);
        UnitResult unit = *parse_unit_result(message.body);
        unit.worker = 100;  // the first worker
        message.body = write_unit_result(unit);
    };
    cluster.add_worker({.dies_of = {}, .changes = pretend, .login = "other"});
    REQUIRE(wait_for_workers(*cluster.backend, 2));
    const auto say_goodbye = [&](int) {
        Hello bye = introduction(Hello::Role::kWorker, 100, "", 1, proof_of(proof_trials(kinds())));
        bye.leaving = true;
        cluster.server.inject_hello(hello_text(bye), "other");
    };
    CHECK(cluster.run(say_goodbye) == expected());
    CHECK(cluster.counts().unknown > 0);
    for (const WorkerStatus& worker : cluster.backend->status().workers)
        CHECK(worker.refusal.empty());
    CHECK(cluster.backend->status().workers.size() == 3);
}

TEST_CASE("a forged greeting of a coordinator ends no worker", "[cluster][threads]") {
    Cluster cluster(1);
    const auto forge = [&](int generation) {
        Hello hello = introduction(Hello::Role::kCoordinator, 0xbad, "forged", 1, 0);
        hello.refusals = {{100, "because"}};
        cluster.server.inject_hello(hello_text(hello));
        if (generation == 6) CHECK(comes_to_say(*cluster.workers.front(), "because"));
    };
    CHECK(cluster.run(forge) == expected());
    REQUIRE(wait_for_workers(*cluster.backend, 1));
    const std::uint64_t units = cluster.counts().units;
    CHECK(cluster.run() == expected());
    CHECK(cluster.counts().units > units);
}

TEST_CASE("a genome that crashes workers is found and saved", "[cluster][threads]") {
    const TemporaryDirectory folder;
    std::mutex mutex;
    std::string poison;  // hash of the genome, as units say it
    // The first creature of the first unit crashes the worker.
    const auto dies = [&](const UnitMessage& unit) {
        const std::lock_guard lock(mutex);
        const std::size_t place = unit.body.find("\"genome\": ");
        if (poison.empty()) poison = unit.body.substr(place, 38);
        return unit.body.find(poison) != std::string::npos;
    };
    ClusterOptions options = drill_options();
    options.crash_folder = folder.path();
    options.child = [&](std::string_view question, const std::stop_token&) -> Result<ChildEnd> {
        const std::lock_guard lock(mutex);
        if (question.find(poison) != std::string_view::npos)
            return ChildEnd{.crashed = true, .cause = "signal 6 (Aborted)", .output = {}};
        return ChildEnd{
            .crashed = false, .cause = {}, .output = *answer_question(question, kinds())};
    };
    Cluster cluster(0, {}, options);
    cluster.add_worker({.dies_of = dies, .changes = {}});
    cluster.add_worker({.dies_of = dies, .changes = {}});
    REQUIRE(wait_for_workers(*cluster.backend, 2));
    CHECK(cluster.run().size() < expected().size());
    const std::string trouble = cluster.backend->status().failure;
    INFO(trouble);
    CHECK(trouble.find("signal 6 (Aborted)") != std::string::npos);
    const std::string hash = poison.substr(poison.find(':', 10) + 1, 16);
    const auto file = folder.path() / ("crash-" + hash + ".creature.json");
    CHECK(trouble.find(file.string()) != std::string::npos);
    const auto creature = load_creature(file, kinds());
    REQUIRE(creature);
    CHECK(hex_text(genome_hash(creature->genome())) == hash);
    CHECK(same_judgement(creature->settings(), drill_settings()));
}

TEST_CASE("overdue units that are sound are computed in a process of their own",
          "[cluster][threads]") {
    ClusterOptions options = drill_options();
    options.child = [](std::string_view question, const std::stop_token&) -> Result<ChildEnd> {
        return ChildEnd{
            .crashed = false, .cause = {}, .output = *answer_question(question, kinds())};
    };
    int units = 0;
    Cluster cluster(0, {}, options);
    const auto second = [&units](const UnitMessage&) { return ++units == 2; };
    cluster.add_worker({.dies_of = second, .changes = {}});
    REQUIRE(wait_for_workers(*cluster.backend, 1));
    CHECK(cluster.run() == expected());
    CHECK(cluster.counts().poisoned > 0);
    CHECK(cluster.backend->status().trouble.empty());
    CHECK(cluster.backend->status().failure.empty());
}

TEST_CASE("units too large for the server are halved", "[cluster][threads]") {
    Faults faults;
    faults.most_bytes = GENERATE(6'000U, 3'000U, 10U);
    Cluster cluster(2, faults);
    CHECK(cluster.run() == expected());
    CHECK((cluster.counts().units > 0) == (faults.most_bytes > 10U));
}

TEST_CASE("a full stream makes the own cores work", "[cluster][threads]") {
    Faults faults;
    faults.most_units = 1;
    Cluster cluster(2, faults);
    CHECK(cluster.run() == expected());
    CHECK(cluster.counts().units > 0);
}

TEST_CASE("garbage on every subject is counted and changes no bit", "[cluster][threads]") {
    Cluster cluster(2);
    RandomStream random(5);
    std::uint32_t injected = 0;
    const auto text = [&random] {
        static const std::vector<std::string> kSamples = {
            "",
            "{",
            "[[[[[[[[",
            "null",
            "\xff\xfe",
            std::string(100'000, '['),
            "{\"format\": \"cambrian-result\", \"version\": 1}",
            "{\"format\": \"cambrian-unit\", \"version\": 1}\nx",
            "{\"format\": \"cambrian-hello\", \"version\": 2}",
            std::string(5'000'000, ' ')};
        return random.pick(kSamples);
    };
    const auto inject = [&](int generation) {
        for (int i = 0; i < 10; ++i) {
            const UnitId id{cluster.server.run(), static_cast<std::uint32_t>(generation + 1),
                            1'000'000 + ++injected};
            cluster.server.inject_result({id, text()});
            cluster.server.inject_unit({{7, 1, injected}, text()});
            cluster.server.inject_hello(text());
        }
    };
    CHECK(cluster.run(inject) == expected());
    CHECK(cluster.counts().malformed >= 2 * injected);
    // None of them is redelivered endlessly.
    for (int tried = 0; tried < 500 && cluster.server.stored_units() > 0; ++tried)
        std::this_thread::sleep_for(milliseconds(10));
    CHECK(cluster.server.stored_units() == 0);
    for (const auto& worker : cluster.workers)
        CHECK_FALSE(worker->said().empty());
}

TEST_CASE("a worker gives back units of another version", "[cluster][threads]") {
    MemoryServer server;
    DrillWorker worker(server, 5);
    const UnitTerms terms{.settings = 1, .simulator = "0.9", .proof = 2, .deadline = 60.0};
    auto genome = std::make_shared<Genome>();
    genome->nodes.resize(1);
    UnitWriter writer(kinds());
    const std::vector<EvaluationRequest> requests = {{.genome = genome}};
    const auto queue = server.coordinator();
    queue->begin_run(9);
    REQUIRE(queue->publish({{9, 1, 0}, writer.write(terms, requests)}) == Publishing::kAccepted);
    std::string refused;
    for (int tried = 0; tried < 100 && refused.empty(); ++tried) {
        for (const HeardHello& heard : queue->poll(milliseconds(50)).hellos)
            refused = parse_hello(heard.text)->refused;
    }
    CHECK(refused == "wants simulator 0.9, this is " + std::string(kSimulatorVersion));
    CHECK(server.stored_units() == 1);
    CHECK(worker.said().back() == "run 0000000000000009 " + refused);
}

TEST_CASE("a run that is stopped goes on with the same bits", "[cluster][threads]") {
    Cluster cluster(2);
    ExperimentSettings settings = drill_settings();
    Evolution evolution(std::make_shared<const ExperimentSettings>(settings), kinds());
    EvaluationProgress progress;
    Digests digests;
    int stops = 0;
    for (int generation = 0; generation < settings.generations; ++generation) {
        if (generation > 0) evolution.breed();
        bool whole = false;
        for (int attempt = 0; !whole; ++attempt) {
            std::stop_source stop;
            std::jthread interruption([&] {
                std::this_thread::sleep_for(milliseconds(15));
                if (attempt < 3) stop.request_stop();
            });
            whole = evolution.evaluate(*cluster.backend, progress, stop.get_token());
            stops += whole ? 0 : 1;
        }
        digests.push_back(population_digest(evolution.population()));
    }
    CHECK(digests == expected());
    CHECK(stops > 0);
}
