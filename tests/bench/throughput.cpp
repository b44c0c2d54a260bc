// The speed of evolution: evaluations per hour and core, the time that cores wait for one another
// at the end of a generation, and the cost of an evaluation besides physics.
#include "app/builtin_kinds.h"
#include "bench/evaluation_cost.h"
#include "bench/write_table.h"
#include "core/stopwatch.h"
#include "core/threads/thread_pool.h"
#include "evolution/evaluation/longest_first.h"
#include "evolution/evaluation/trials.h"
#include "evolution/evolution.h"
#include "persist/settings/settings_file.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <numeric>
#include <vector>

using namespace cambrian;

namespace {

// Works like the production back-end and measures the time of every worker.
class TimedBackend final : public EvaluationBackend {
public:
    TimedBackend(const EvolutionKinds& kinds, std::size_t workers)
        : kinds_(kinds), pool_(workers), busy_(workers, 0.0) {}

    bool evaluate(std::span<const EvaluationRequest> requests,
                  std::span<std::optional<EvaluationResult>> results,
                  const ExperimentSettings& settings, EvaluationProgress& /*progress*/,
                  std::stop_token stop) override {
        const Stopwatch whole;
        std::vector<std::size_t> order(requests.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        put_longest_first(order, requests);
        const bool complete = pool_.parallel_for(
            requests.size(),
            [&](std::size_t index, std::size_t worker) {
                const Stopwatch one;
                const std::size_t next = order[index];
                results[next] = evaluate_in_trials(requests[next], settings, kinds_);
                busy_[worker] += one.seconds();
                longest_ = std::max(longest_.load(), one.seconds());
            },
            std::move(stop));
        wall_ += whole.seconds();
        evaluations_ += requests.size();
        return complete;
    }

    double wall() const { return wall_; }
    double busy() const { return std::accumulate(busy_.begin(), busy_.end(), 0.0); }
    double longest() const { return longest_; }
    std::size_t workers() const { return pool_.workers(); }
    std::size_t evaluations() const { return evaluations_; }

private:
    const EvolutionKinds& kinds_;
    ThreadPool pool_;
    std::vector<double> busy_;  // s, one per worker
    std::atomic<double> longest_ = 0.0;
    double wall_ = 0.0;
    std::size_t evaluations_ = 0;
};

struct Options {
    std::string settings;
    int generations = 5;
    int size = 300;
    std::size_t threads = 2;
    std::string csv_path;
};

double evaluations_an_hour_and_core(const TimedBackend& backend) {
    const double capacity = static_cast<double>(backend.workers()) * backend.wall();
    return 3600.0 * static_cast<double>(backend.evaluations()) / capacity;
}

void report_generations(const TimedBackend& backend, double breeding) {
    const double cores = static_cast<double>(backend.workers());
    const double capacity = cores * backend.wall();
    std::printf("evaluations            %zu in %.2f s on %zu threads\n", backend.evaluations(),
                backend.wall(), backend.workers());
    std::printf("an hour and core       %.0f\n", evaluations_an_hour_and_core(backend));
    std::printf("longest                %.3f s, mean %.3f s\n", backend.longest(),
                backend.busy() / static_cast<double>(backend.evaluations()));
    std::printf("idle share of the pool %.2f %% (target below 5)\n",
                100.0 * (1.0 - backend.busy() / capacity));
    std::printf("breeding, one thread   %.3f s, %.2f %% of the run\n", breeding,
                100.0 * breeding / (breeding + backend.wall()));
}

bench::EvaluationCost cost_of(const std::vector<IndividualPtr>& population,
                              const ExperimentSettings& settings, const EvolutionKinds& kinds) {
    bench::EvaluationCost sum;
    for (const IndividualPtr& individual : population) {
        if (individual->result.outcome == Outcome::kCompleted)
            sum += bench::measure_cost(*individual->genome, settings, kinds);
    }
    return sum;
}

double percent_not_physics(const bench::EvaluationCost& cost) {
    return 100.0 * (1.0 - cost.physics / cost.total());
}

void report_costs(const bench::EvaluationCost& sum) {
    std::printf(
        "an evaluation's cost   expression %.2f %%, scoring %.2f %%, control and "
        "bookkeeping %.2f %%, physics %.2f %%\n",
        100.0 * sum.expression / sum.total(), 100.0 * sum.scoring / sum.total(),
        100.0 * sum.control() / sum.total(), 100.0 * sum.physics / sum.total());
    std::printf("overhead               %.2f %% (target below 10)\n", percent_not_physics(sum));
}

std::string csv_of(const TimedBackend& backend, const bench::EvaluationCost& cost) {
    char text[256];
    std::snprintf(text, sizeof text,
                  "figure,value\nevaluations_an_hour_and_core,%.6g\npercent_not_physics,%.6g\n",
                  evaluations_an_hour_and_core(backend), percent_not_physics(cost));
    return text;
}

int run(const Options& options) {
    const EvolutionKinds kinds = builtin_kinds();
    Result<ExperimentSettings> settings = load_settings(options.settings, kinds);
    if (!settings) {
        std::fprintf(stderr, "%s\n", settings.error().message.c_str());
        return 2;
    }
    settings->population.size = options.size;
    TimedBackend backend(kinds, options.threads);
    Evolution evolution(std::make_shared<const ExperimentSettings>(*settings), kinds);
    EvaluationProgress progress;
    double breeding = 0.0;
    for (int i = 0; i < options.generations; ++i) {
        if (i > 0) {
            const Stopwatch bred;
            evolution.breed();
            breeding += bred.seconds();
        }
        evolution.evaluate(backend, progress, {});
    }
    report_generations(backend, breeding);
    const bench::EvaluationCost cost = cost_of(evolution.population(), *settings, kinds);
    report_costs(cost);
    return bench::write_table(options.csv_path, csv_of(backend, cost));
}

}  // namespace

int main(int argc, char** argv) {
    Options options;
    CLI::App app("Evaluations an hour, idle cores and overhead of an evolution.");
    app.add_option("settings", options.settings, "Settings file, e.g. assets/settings/walking.toml")
        ->required();
    app.add_option("-n,--generations", options.generations, "Generations")
        ->check(CLI::Range(1, 1000));
    app.add_option("--size", options.size, "Creatures a generation")->check(CLI::Range(2, 20000));
    app.add_option("-t,--threads", options.threads, "Threads")->check(CLI::Range(1, 1024));
    app.add_option("--csv", options.csv_path, "File to write the figures to");
    CLI11_PARSE(app, argc, argv);
    return run(options);
}
