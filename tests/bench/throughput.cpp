// The speed of evolution: evaluations per hour and core, the time that cores wait for one another
// at the end of a generation, and the cost of an evaluation besides physics. Other versions of the
// simulator breed other creatures from the same seed, so versions are compared on creatures from
// files.
#include "app/builtin_kinds.h"
#include "bench/evaluation_cost.h"
#include "bench/write_table.h"
#include "core/stopwatch.h"
#include "core/threads/thread_pool.h"
#include "evolution/evaluation/longest_first.h"
#include "evolution/evaluation/trials.h"
#include "evolution/evolution.h"
#include "persist/creature/creature_file.h"
#include "persist/settings/settings_file.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <filesystem>
#include <numeric>
#include <system_error>
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
        for (const EvaluationRequest& request : requests)
            genomes_.push_back(request.genome);
        return complete;
    }

    double wall() const { return wall_; }
    double busy() const { return std::accumulate(busy_.begin(), busy_.end(), 0.0); }
    double longest() const { return longest_; }
    std::size_t workers() const { return pool_.workers(); }
    std::size_t evaluations() const { return genomes_.size(); }
    const std::vector<GenomePtr>& genomes() const { return genomes_; }

private:
    const EvolutionKinds& kinds_;
    ThreadPool pool_;
    std::vector<double> busy_;  // s, one per worker
    std::atomic<double> longest_ = 0.0;
    double wall_ = 0.0;
    std::vector<GenomePtr> genomes_;  // of all evaluations
};

struct Options {
    std::string settings;
    std::filesystem::path creatures;
    std::filesystem::path keep;
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

void add_cost(const GenomePtr& genome, const EvaluationResult& result,
              const ExperimentSettings& settings, const EvolutionKinds& kinds,
              bench::EvaluationCost& sum) {
    if (result.outcome == Outcome::kCompleted) sum += bench::measure_cost(*genome, settings, kinds);
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

// Returns the cost of the last generation's creatures.
bench::EvaluationCost evolve(const Options& options, const ExperimentSettings& settings,
                             const EvolutionKinds& kinds, TimedBackend& backend) {
    Evolution evolution(std::make_shared<const ExperimentSettings>(settings), kinds);
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
    bench::EvaluationCost cost;
    for (const IndividualPtr& one : evolution.population())
        add_cost(one->genome, one->result, settings, kinds, cost);
    return cost;
}

Result<std::vector<GenomePtr>> load_genomes(const std::filesystem::path& folder,
                                            const EvolutionKinds& kinds) {
    std::error_code failure;
    const std::filesystem::directory_iterator entries(folder, failure);
    if (failure) return Error{folder.string() + ": " + failure.message()};
    std::vector<std::filesystem::path> paths;
    for (const auto& entry : entries)
        paths.push_back(entry.path());
    std::sort(paths.begin(), paths.end());
    std::vector<GenomePtr> genomes;
    for (const std::filesystem::path& path : paths) {
        auto document = load_creature(path, kinds);
        if (!document) return document.error();
        genomes.push_back(document->creature.individual->genome);
    }
    if (genomes.empty()) return Error{folder.string() + ": no creature"};
    return genomes;
}

bench::EvaluationCost evaluate(const std::vector<GenomePtr>& genomes,
                               const ExperimentSettings& settings, const EvolutionKinds& kinds,
                               TimedBackend& backend) {
    std::vector<EvaluationRequest> requests;
    for (const GenomePtr& genome : genomes)
        requests.push_back({.genome = genome, .trial_seed = trial_seed(settings)});
    std::vector<std::optional<EvaluationResult>> results(requests.size());
    EvaluationProgress progress;
    backend.evaluate(requests, results, settings, progress, {});
    report_generations(backend, 0.0);
    bench::EvaluationCost cost;
    for (std::size_t i = 0; i < genomes.size(); ++i)
        add_cost(genomes[i], *results[i], settings, kinds, cost);
    return cost;
}

Status save_genomes(const std::filesystem::path& folder, const std::vector<GenomePtr>& genomes,
                    const EvolutionKinds& kinds) {
    std::error_code failure;
    std::filesystem::create_directories(folder, failure);
    if (failure) return Error{folder.string() + ": " + failure.message()};
    for (std::size_t i = 0; i < genomes.size(); ++i) {
        const CreatureDocument document{.creature = unjudged(genomes[i])};
        const auto path = folder / fmt::format("{:05}.creature.json", i);
        if (const Status saved = save_creature(path, document, kinds); !saved) return saved;
    }
    return {};
}

int refuse(const Error& error) {
    std::fprintf(stderr, "%s\n", error.message.c_str());
    return 2;
}

int run(const Options& options) {
    const EvolutionKinds kinds = builtin_kinds();
    Result<ExperimentSettings> settings = load_settings(options.settings, kinds);
    if (!settings) return refuse(settings.error());
    settings->population.size = options.size;
    TimedBackend backend(kinds, options.threads);
    bench::EvaluationCost cost;
    if (options.creatures.empty()) {
        cost = evolve(options, *settings, kinds, backend);
    } else {
        const auto genomes = load_genomes(options.creatures, kinds);
        if (!genomes) return refuse(genomes.error());
        cost = evaluate(*genomes, *settings, kinds, backend);
    }
    if (!options.keep.empty()) {
        const Status saved = save_genomes(options.keep, backend.genomes(), kinds);
        if (!saved) return refuse(saved.error());
    }
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
    app.add_option("--creatures", options.creatures,
                   "Folder of creature files to evaluate instead of an evolution")
        ->check(CLI::ExistingDirectory)
        ->excludes("--generations", "--size");
    app.add_option("--keep", options.keep,
                   "Folder to save every evaluated creature in, for --creatures");
    app.add_option("--csv", options.csv_path, "File to write the figures to");
    CLI11_PARSE(app, argc, argv);
    return run(options);
}
