// Measures on one machine how well a cluster of many cores is used. The coordinator and the server
// are real. The workers' cores sleep for the time that reading and evaluating a unit takes, then
// answer with results computed before. Prints a Markdown table of the share of time the cores spend
// on evaluations.
#include "app/builtin_kinds.h"
#include "cluster/connection/cluster_connection.h"
#include "cluster/coordinator/cluster_backend.h"
#include "cluster/messages/hello_text.h"
#include "cluster/messages/proof_set.h"
#include "cluster/messages/result_text.h"
#include "cluster/messages/unit_text.h"
#include "core/random_id.h"
#include "core/stopwatch.h"
#include "core/thread_time.h"
#include "evolution/evaluation/trials.h"
#include "evolution/evolution.h"
#include "genome/genome.h"
#include "persist/settings/settings_file.h"
#include "persist/text/digest_text.h"
#include "simulator/simulator_version.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <condition_variable>
#include <cstdio>
#include <deque>
#include <map>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <sys/resource.h>
#include <thread>
#include <vector>

using namespace cambrian;

namespace {

constexpr int kCoresOfMachine = 8;

// Efficiencies of a prototype without checks and breeding, from which the help page estimates how
// many cores a run can use.
struct Prototype {
    int creatures = 0;
    double mean_ms = 0.0;
    int cores = 0;
    double efficiency = 0.0;  // %
};
constexpr Prototype kPrototypes[] = {{300, 3.0, 16, 64.0},
                                     {300, 10.0, 16, 86.0},
                                     {2'000, 10.0, 64, 83.0},
                                     {2'000, 40.0, 64, 92.0},
                                     {20'000, 10.0, 256, 67.0}};

std::string prototype_efficiency(int creatures, double mean_ms, int cores) {
    for (const Prototype& each : kPrototypes) {
        if (each.creatures == creatures && each.mean_ms == mean_ms && each.cores == cores)
            return fmt::format("{:.0f} %", each.efficiency);
    }
    return "–";
}

// Returns the processor time of this process, in s: that of the coordinators and of both sides'
// text.
double processor_seconds() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const auto seconds = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

// The result of an evaluation that was made in advance.
struct Answer {
    EvaluationResult result;
    double seconds = 0.0;  // core-seconds to evaluate
    double reading = 0.0;  // core-seconds to read the creature from a unit
};
using Question = std::pair<std::uint64_t, std::uint64_t>;  // genome and seed
using Answers = std::map<Question, Answer>;                // of one batch

Question question_of(const EvaluationRequest& request) {
    return {genome_hash(*request.genome), request.trial_seed};
}

// Evaluates on this thread and keeps the largest batch with its results.
class Rehearsal final : public EvaluationBackend {
public:
    explicit Rehearsal(const EvolutionKinds& kinds) : kinds_(kinds) {}

    bool evaluate(std::span<const EvaluationRequest> requests,
                  std::span<std::optional<EvaluationResult>> results,
                  const ExperimentSettings& settings, EvaluationProgress& /*progress*/,
                  std::stop_token stop) override {
        const bool largest = requests.size() >= batch.size();
        if (largest) batch.assign(requests.begin(), requests.end());
        if (largest) answers.clear();
        for (std::size_t i = 0; i < requests.size(); ++i) {
            ThreadTimer timer;
            results[i] = evaluate_in_trials(requests[i], settings, kinds_, stop);
            if (largest) answers[question_of(requests[i])] = {*results[i], timer.lap()};
        }
        return true;
    }

    std::vector<EvaluationRequest> batch;
    Answers answers;

private:
    const EvolutionKinds& kinds_;
};

// A worker whose cores sleep instead of evaluating.
class SleepingMachine {
public:
    SleepingMachine(std::unique_ptr<WorkerQueue> queue, const Answers& answers, int cores,
                    std::uint64_t proof)
        : queue_(std::move(queue)), answers_(answers), cores_(cores), proof_(proof) {
        for (int core = 0; core < cores; ++core)
            threads_.emplace_back([this](const std::stop_token& stop) { serve(stop); });
        threads_.emplace_back([this](const std::stop_token& stop) { fetch(stop); });
    }

private:
    void fetch(const std::stop_token& stop) {
        double next_hello = 0.0;
        while (!stop.stop_requested()) {
            static_cast<void>(queue_->poll());
            if (clock_.seconds() >= next_hello) {
                next_hello = clock_.seconds() + kHelloEvery;
                say_hello();
            }
            const std::size_t wanted = room();
            if (wanted == 0) {
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
                continue;
            }
            std::vector<Delivery> fetched = queue_->fetch(wanted, std::chrono::milliseconds(250));
            const std::lock_guard lock(mutex_);
            in_hand_ += fetched.size();
            std::move(fetched.begin(), fetched.end(), std::back_inserter(waiting_));
            changed_.notify_all();
        }
    }
    std::size_t room() {
        const std::lock_guard lock(mutex_);
        return 2 * static_cast<std::size_t>(cores_) - in_hand_;
    }
    void say_hello() {
        Hello hello;
        hello.id = id_;
        hello.name = "sleeping";
        hello.cores = cores_;
        hello.simulator = kSimulatorVersion;
        hello.proof = proof_;
        queue_->say_hello(hex_text(id_), hello_text(hello));
    }
    void serve(const std::stop_token& stop) {
        for (;;) {
            std::unique_lock lock(mutex_);
            if (!changed_.wait(lock, stop, [this] { return !waiting_.empty(); })) return;
            const Delivery delivery = std::move(waiting_.front());
            waiting_.pop_front();
            lock.unlock();
            answer(delivery);
            lock.lock();
            --in_hand_;
        }
    }
    struct Reply {
        UnitResult unit;
        double reading = 0.0;  // core-seconds to read the unit
    };
    // Creatures are identified by the unit's first line. Their documents are not read, since two
    // cores cannot read for hundreds.
    // Returns nothing for a unit of another run, which an earlier benchmark may have left.
    std::optional<Reply> reply_to(const Delivery& delivery) const {
        const std::string& body = delivery.unit.body;
        const auto line = nlohmann::json::parse(body.substr(0, body.find('\n')));
        Reply reply;
        reply.unit.worker = id_;
        reply.unit.deliveries = delivery.times;
        for (const auto& creature : line.at("creatures")) {
            const auto genome = parse_digest(creature.at("genome").get<std::string>()).value();
            const auto seed = parse_digest(creature.at("seed").get<std::string>()).value();
            const auto found = answers_.find({genome, seed});
            if (found == answers_.end()) return std::nullopt;
            reply.reading += found->second.reading;
            reply.unit.seconds += found->second.seconds;
            reply.unit.results.push_back(
                {creature.at("slot").get<std::uint32_t>(), genome, found->second.result});
        }
        return reply;
    }
    void answer(const Delivery& delivery) {
        if (const auto reply = reply_to(delivery)) {
            std::this_thread::sleep_for(
                std::chrono::duration<double>(reply->reading + reply->unit.seconds));
            while (!queue_->publish_result({delivery.unit.id, write_unit_result(reply->unit)}))
                std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
        queue_->acknowledge(delivery.ticket);
    }

    const std::unique_ptr<WorkerQueue> queue_;
    const Answers& answers_;
    const int cores_;
    const std::uint64_t proof_;
    const std::uint64_t id_ = random_id();
    const Stopwatch clock_;
    std::mutex mutex_;
    std::condition_variable_any changed_;
    std::deque<Delivery> waiting_;
    std::size_t in_hand_ = 0;
    std::vector<std::jthread> threads_;  // last member, since they use the others
};

struct Bench {
    std::string server;
    std::string settings;
    int population = 300;
    double mean_ms = 0.0;  // mean duration of a worker's evaluation; 0 for the one measured here
    // Generations before the measurement, in which many results of new workers are checked.
    int warm_up = 12;
    int generations = 10;
    int runs = 1;  // at once, each with a coordinator of its own
    std::vector<int> cores = {16, 64, 256};

    // Cores of this machine that evaluate: each run has a thread for it.
    int own_cores() const {
        return std::min(runs, static_cast<int>(std::thread::hardware_concurrency()));
    }
};

double core_seconds(const Rehearsal& rehearsal) {
    double sum = 0.0;
    for (const EvaluationRequest& request : rehearsal.batch)
        sum += rehearsal.answers.at(question_of(request)).seconds;
    return sum;
}

double mean_ms(const Rehearsal& rehearsal) {
    return 1e3 * core_seconds(rehearsal) / static_cast<double>(rehearsal.batch.size());
}

// Evaluates a later generation of a run, in which parents' work predicts each creature's.
Rehearsal rehearse(const ExperimentSettings& settings, double asked_mean_ms,
                   const EvolutionKinds& kinds) {
    Rehearsal rehearsal(kinds);
    Evolution evolution(std::make_shared<const ExperimentSettings>(settings), kinds);
    EvaluationProgress progress;
    for (int generation = 0; generation < 2; ++generation) {
        rehearsal.batch.clear();
        evolution.evaluate(rehearsal, progress, {});
        evolution.breed();
    }
    UnitWriter writer(kinds);
    UnitReader reader(kinds);
    for (const EvaluationRequest& request : rehearsal.batch) {
        const std::string body =
            writer.write({.simulator = std::string(kSimulatorVersion)}, {&request, 1});
        ThreadTimer timer;
        if (!reader.read(body)) throw std::logic_error("a unit that was written cannot be read");
        rehearsal.answers[question_of(request)].reading = timer.lap();
    }
    const double scale = asked_mean_ms > 0.0 ? asked_mean_ms / mean_ms(rehearsal) : 1.0;
    for (auto& [question, answer] : rehearsal.answers)
        answer.seconds *= scale;
    return rehearsal;
}

using Backends = std::vector<std::unique_ptr<EvaluationBackend>>;
using Machines = std::vector<std::unique_ptr<SleepingMachine>>;

Result<Backends> connect_runs(const ClusterAddress& address, int runs,
                              const EvolutionKinds& kinds) {
    Backends backends;
    for (int run = 0; run < runs; ++run) {
        auto coordinator = connect_coordinator(address, "");
        if (!coordinator) return coordinator.error();
        ClusterOptions options;
        options.run = random_id();
        options.secret = random_id();
        backends.push_back(make_cluster_backend(kinds, *std::move(coordinator), options));
    }
    return backends;
}

Result<Machines> connect_machines(const ClusterAddress& address, int cores, const Answers& answers,
                                  std::uint64_t proof) {
    Machines machines;
    for (int left = cores; left > 0; left -= kCoresOfMachine) {
        auto queue = connect_worker(address);
        if (!queue) return queue.error();
        machines.push_back(std::make_unique<SleepingMachine>(
            *std::move(queue), answers, std::min(left, kCoresOfMachine), proof));
    }
    return machines;
}

bool wait_for(const EvaluationBackend& backend, int cores) {
    for (int tries = 0; tries < 600; ++tries) {
        if (static_cast<int>(totals(backend.status()).cores) >= cores) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    return false;
}

// Seconds of each generation of a run; an Error if the run fails.
Result<std::vector<double>> evaluate_generations(EvaluationBackend& backend, int generations,
                                                 const ExperimentSettings& settings,
                                                 const Rehearsal& rehearsal) {
    std::vector<double> times;
    while (static_cast<int>(times.size()) < generations) {
        std::vector<std::optional<EvaluationResult>> results(rehearsal.batch.size());
        EvaluationProgress progress;
        const Stopwatch watch;
        if (!backend.evaluate(rehearsal.batch, results, settings, progress, {}))
            return Error{backend.status().failure};
        times.push_back(watch.seconds());
    }
    return times;
}

struct RunTimes {
    std::vector<double> generations;  // s, of all runs, the shortest first
    double all = 0.0;                 // s, until the last run ended

    // The time of a generation. Runs at once share the cores unevenly, so only their end counts.
    double generation(int runs) const {
        const std::size_t count = generations.size();
        return runs == 1 ? generations[count / 2] : all * runs / static_cast<double>(count);
    }
};

// All runs at once.
Result<RunTimes> evaluate_runs(const Backends& backends, int generations,
                               const ExperimentSettings& settings, const Rehearsal& rehearsal) {
    std::vector<Result<std::vector<double>>> outcomes(backends.size(), Error{});
    const Stopwatch watch;
    {
        std::vector<std::jthread> threads;
        for (std::size_t run = 0; run < backends.size(); ++run) {
            threads.emplace_back([&, run] {
                // The sleeping machines have no processor of their own.
                take_priority(ThreadPriority::kBackground);
                outcomes[run] =
                    evaluate_generations(*backends[run], generations, settings, rehearsal);
            });
        }
    }
    RunTimes times{.generations = {}, .all = watch.seconds()};
    for (const auto& outcome : outcomes) {
        if (!outcome) return outcome.error();
        times.generations.insert(times.generations.end(), outcome->begin(), outcome->end());
    }
    std::sort(times.generations.begin(), times.generations.end());
    return times;
}

// A row of the table. cores: in all, those of this machine among them.
Status measure(const Bench& bench, int cores, const ExperimentSettings& settings,
               const Rehearsal& rehearsal, const EvolutionKinds& kinds) {
    const Result<ClusterAddress> address = cluster_address({.servers = bench.server});
    if (!address) return address.error();
    const auto backends = connect_runs(*address, bench.runs, kinds);
    if (!backends) return backends.error();
    const int remote = cores - bench.own_cores();
    const auto machines =
        connect_machines(*address, remote, rehearsal.answers, proof_of(proof_trials(kinds)));
    if (!machines) return machines.error();
    for (const auto& backend : *backends) {
        if (!wait_for(*backend, remote + 1)) return Error{"the workers did not appear"};
    }
    const auto before = evaluate_runs(*backends, bench.warm_up, settings, rehearsal);
    if (!before) return before.error();
    const double processor_before = processor_seconds();
    const auto times = evaluate_runs(*backends, bench.generations, settings, rehearsal);
    if (!times) return times.error();
    const double used = processor_seconds() - processor_before;
    const double generation = times->generation(bench.runs);
    const double ideal = bench.runs * core_seconds(rehearsal) / cores;
    std::printf("| %d x %zu x %.1f ms | %d | %.0f | %.0f | %.0f | %.0f %% | %s | %.0f |\n",
                bench.runs, rehearsal.batch.size(), mean_ms(rehearsal), cores, 1e3 * ideal,
                1e3 * generation, 1e3 * times->generations.back(), 100.0 * ideal / generation,
                prototype_efficiency(bench.population, bench.mean_ms, cores).c_str(),
                1e3 * used / bench.generations);
    std::fflush(stdout);
    return {};
}

int run(const Bench& bench) {
    const EvolutionKinds kinds = builtin_kinds();
    Result<ExperimentSettings> settings = load_settings(bench.settings, kinds);
    if (!settings) {
        std::fprintf(stderr, "%s\n", settings.error().message.c_str());
        return 2;
    }
    settings->population.size = bench.population;
    const Rehearsal rehearsal = rehearse(*settings, bench.mean_ms, kinds);
    std::printf(
        "| runs x creatures | cores | ideal ms | generation ms | worst ms | efficiency | prototype "
        "| processor ms |\n"
        "|---|---|---|---|---|---|---|---|\n");
    for (const int cores : bench.cores) {
        if (const Status done = measure(bench, cores, *settings, rehearsal, kinds); !done) {
            std::fprintf(stderr, "%s\n", done.error().message.c_str());
            return 1;
        }
    }
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    Bench bench;
    CLI::App app("How well a cluster of many cores is used; its workers sleep");
    app.add_option("server", bench.server, "nats://127.0.0.1:4222, with JetStream")->required();
    app.add_option("settings", bench.settings, "Settings file (*.toml)")->required();
    app.add_option("--population", bench.population, "Creatures")->check(CLI::Range(10, 20'000));
    app.add_option("--mean-ms", bench.mean_ms,
                   "What an evaluation of a worker takes on average; 0: as long as on this machine")
        ->check(CLI::Range(0.0, 10'000.0));
    app.add_option("--warm-up", bench.warm_up,
                   "Generations before, in which many results of new workers are checked")
        ->check(CLI::Range(0, 1000));
    app.add_option("--generations", bench.generations, "Measured")->check(CLI::Range(1, 1000));
    app.add_option("--runs", bench.runs, "At once, each with a coordinator of its own")
        ->check(CLI::Range(1, 64));
    app.add_option("--cores", bench.cores, "In all")->check(CLI::Range(2, 4096));
    CLI11_PARSE(app, argc, argv);
    return run(bench);
}
