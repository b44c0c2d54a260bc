// cambrian_bench_quality: measures how well evolution searches (quality/README.md). It performs the
// runs of a plan, one per thread, and saves each when it ends. Runs that are already saved are not
// repeated.

#include "app/builtin_kinds.h"
#include "core/files/file_io.h"
#include "core/threads/thread_pool.h"
#include "quality/plan.h"
#include "quality/report.h"
#include "quality/run_table.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <fstream>
#include <mutex>

using namespace cambrian;
using namespace cambrian::quality;

namespace {

constexpr int kFailed = 1;
constexpr int kBadInput = 2;

struct Options {
    std::string plan;
    std::filesystem::path folder = ".";
    std::filesystem::path page;
    std::size_t threads = ThreadPool::default_workers();
};

int refuse(const Error& error) {
    std::fprintf(stderr, "%s\n", error.message.c_str());
    return kBadInput;
}

bool same_run(const RunSpec& a, const RunSpec& b) {
    return a.plan == b.plan && a.goal == b.goal && a.arm == b.arm && a.seed == b.seed &&
           a.size == b.size && a.budget == b.budget;
}

std::vector<RunSpec> still_to_run(const std::string& plan, const std::vector<RunResult>& done) {
    std::vector<RunSpec> runs = plan_of(plan);
    const auto is_done = [&](const RunSpec& run) {
        return std::any_of(done.begin(), done.end(),
                           [&](const RunResult& result) { return same_run(result, run); });
    };
    runs.erase(std::remove_if(runs.begin(), runs.end(), is_done), runs.end());
    return runs;
}

// Two files to which one run at a time is added.
class RunTables {
public:
    explicit RunTables(const std::filesystem::path& folder)
        : runs_(open(folder / "runs.csv", run_header())),
          curves_(open(folder / "curves.csv", curve_header())) {}

    bool keep(const RunResult& result) {
        const std::lock_guard<std::mutex> lock(mutex_);
        runs_ << run_line(result) << std::flush;
        curves_ << curve_lines(result) << std::flush;
        std::printf("%s %s %s seed %llu: %g after %d evaluations, %.0f s\n", result.plan.c_str(),
                    result.goal.c_str(), result.arm.c_str(),
                    static_cast<unsigned long long>(result.seed), result.best, result.evaluations,
                    result.seconds);
        std::fflush(stdout);
        return runs_.good() && curves_.good();
    }

private:
    static std::ofstream open(const std::filesystem::path& path, const std::string& header) {
        const bool fresh = !std::filesystem::exists(path);
        std::ofstream file(path, std::ios::app);
        if (fresh) file << header << std::flush;
        return file;
    }

    std::mutex mutex_;
    std::ofstream runs_;
    std::ofstream curves_;
};

int run_plan(const Options& options) {
    const std::filesystem::path champions = options.folder / "champions";
    std::error_code failure;
    std::filesystem::create_directories(champions, failure);
    if (failure) return refuse({champions.string() + ": " + failure.message()});
    const auto done = read_runs(options.folder / "runs.csv");
    if (!done) return refuse(done.error());
    const EvolutionKinds kinds = builtin_kinds();
    const std::vector<RunSpec> runs = still_to_run(options.plan, *done);
    RunTables tables(options.folder);
    std::atomic<bool> complete = true;
    ThreadPool pool(options.threads);
    pool.parallel_for(runs.size(), [&](std::size_t index, std::size_t /*worker*/) {
        const auto result = perform(runs[index], kinds, champions);
        if (result && tables.keep(*result)) return;
        refuse(result ? Error{options.folder.string() + ": a run could not be written"}
                      : result.error());
        complete = false;
    });
    return complete ? 0 : kBadInput;
}

int write_report(const Options& options) {
    const auto runs = read_runs(options.folder / "runs.csv");
    if (!runs) return refuse(runs.error());
    std::string page;
    for (const auto& [plan, title, criteria] :
         {std::tuple{"standard", "3000 evaluations", standard_criteria(*runs)},
          std::tuple{"long", "20 000 evaluations", long_criteria(*runs)},
          std::tuple{"seeking", "Seeking a light", seeking_criteria(*runs)}}) {
        page += "\n## " + std::string(title) + "\n\n";
        if (!criteria.empty()) page += criteria_table(criteria);
        page += arm_tables(*runs, plan);
    }
    const Status written = write_file(options.page, page);
    return written ? 0 : refuse(written.error());
}

int check(const Options& options) {
    const EvolutionKinds kinds = builtin_kinds();
    const std::vector<RunSpec> specs = plan_of("quick");
    std::vector<RunResult> runs(specs.size());
    ThreadPool pool(options.threads);
    pool.parallel_for(specs.size(), [&](std::size_t index, std::size_t /*worker*/) {
        // The quick plan has the goals' defaults, which need no file.
        runs[index] = perform(specs[index], kinds, {}).value();
    });
    const std::vector<Criterion> criteria = quick_criteria(runs);
    std::printf("%s%s", criteria_table(criteria).c_str(), arm_tables(runs, "quick").c_str());
    const bool holds = std::all_of(criteria.begin(), criteria.end(), [](const Criterion& found) {
        return found.finding == Finding::kHolds;
    });
    return holds ? 0 : kFailed;
}

}  // namespace

int main(int argc, char** argv) {
    Options options;
    CLI::App app("How well evolution searches.");
    app.require_subcommand(1);
    app.add_option("-t,--threads", options.threads, "Runs at a time")->check(CLI::Range(1, 1024));
    CLI::App* run = app.add_subcommand("run", "Run what is missing of a plan");
    run->add_option("plan", options.plan, "Which")
        ->required()
        ->check(CLI::IsMember({"standard", "long", "quick", "seeking"}));
    run->add_option("-o,--out", options.folder, "Folder of runs.csv, curves.csv and champions/");
    CLI::App* report = app.add_subcommand("report", "Write the criteria and all values as a page");
    report->add_option("-i,--in", options.folder, "Folder of runs.csv");
    report->add_option("-o,--out", options.page, "The page, *.md")->required();
    app.add_subcommand("check", "Run the quick plan; fails unless its criteria hold");
    CLI11_PARSE(app, argc, argv);
    if (run->parsed()) return run_plan(options);
    if (report->parsed()) return write_report(options);
    return check(options);
}
