#include "app/cluster/cluster_options.h"
#include "app/command_line/number_checks.h"
#include "app/command_line/option_types.h"
#include "app/command_line/seed_list.h"
#include "app/evolve/comparison_pictures.h"
#include "app/process/interruption.h"
#include "app/process/messages.h"
#include "app/process/progress_line.h"
#include "app/subcommands/subcommands.h"
#include "cluster/join_cluster.h"
#include "comparison/comparison.h"
#include "comparison/plan.h"
#include "comparison/report.h"
#include "comparison/sweep.h"
#include "core/files/file_io.h"
#include "core/stopwatch.h"
#include "core/text/counted.h"
#include "core/text/pretty_text.h"
#include "core/threads/thread_pool.h"
#include "evolution/backends/thread_pool_backend.h"
#include "persist/settings/typed_setting.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <optional>

namespace cambrian {
namespace {

constexpr const char* kPlainArm = "default";

struct CompareOptions {
    std::vector<std::string> arms;
    std::vector<std::string> worlds;
    std::vector<std::string> sets;
    std::string sweep;
    std::string seeds = "1..9";
    std::string out = "comparison";
    int trials = 4000;
    bool random_search = false;
    std::string museum;
    std::optional<std::size_t> threads;
    ClusterLogin cluster;  // without servers, only this machine evaluates
};

Result<std::vector<NamedSettings>> named_settings(const std::vector<std::string>& files) {
    std::vector<NamedSettings> some;
    for (const std::string& file : files) {
        Result<SettingsText> text = read_settings_text(file);
        if (!text) return text.error();
        some.push_back({std::filesystem::path(file).stem().string(), {*std::move(text)}});
    }
    return some;
}

// Returns every arm once for each value of "key=value,value...".
Result<std::vector<NamedSettings>> swept(const std::vector<NamedSettings>& arms,
                                         const std::string& sweep, const EvolutionKinds& kinds) {
    const std::size_t sign = sweep.find('=');
    if (sign == std::string::npos) return Error{"--sweep: expected key=value,value..."};
    const std::string key = sweep.substr(0, sign);
    auto all = swept_arms(arms, key, CLI::detail::split(sweep.substr(sign + 1), ','), kinds);
    if (!all) return Error{"--sweep: " + all.error().message};
    return all;
}

Result<std::vector<NamedSettings>> arms_of(const CompareOptions& options,
                                           const EvolutionKinds& kinds) {
    auto arms = named_settings(options.arms);
    if (!arms) return arms.error();
    if (arms->empty()) arms->push_back({kPlainArm, {{"", kPlainArm}}});
    for (const std::string& assignment : options.sets) {
        const Result<SettingsText> text = typed_setting(assignment, kinds);
        if (!text) return Error{"--set: " + text.error().message};
        for (NamedSettings& arm : *arms)
            arm.texts.push_back(*text);
    }
    return options.sweep.empty() ? arms : swept(*arms, options.sweep, kinds);
}

Result<std::vector<PlannedRun>> runs_of(const CompareOptions& options,
                                        const EvolutionKinds& kinds) {
    auto worlds = named_settings(options.worlds);
    if (!worlds) return worlds.error();
    auto arms = arms_of(options, kinds);
    if (!arms) return arms.error();
    auto seeds = parse_seeds(options.seeds);
    if (!seeds) return Error{"--seeds: " + seeds.error().message};
    return planned_runs({.worlds = *std::move(worlds),
                         .arms = *std::move(arms),
                         .random_search = options.random_search,
                         .seeds = *std::move(seeds),
                         .trials = options.trials,
                         .museum = options.museum},
                        kinds);
}

// Makes back-ends of one core of this machine and, if one is named, the cluster.
Result<BackendMaking> backend_making(const ClusterLogin& cluster, const EvolutionKinds& kinds) {
    if (cluster.servers.empty()) {
        return BackendMaking([&kinds]() -> Result<std::unique_ptr<EvaluationBackend>> {
            return make_thread_pool_backend(kinds, 1);
        });
    }
    if (kinds.creature.scene.dimensions == 3)
        return Error{"clusters are not built in three dimensions yet"};
    const Result<ClusterAddress> address = usable_cluster(cluster);
    if (!address) return address.error();
    return BackendMaking(
        [&kinds, address = *address] { return join_cluster(kinds, address, {.experiment = {}}); });
}

std::string run_line(const ComparedRun& run) {
    return fmt::format("{}, {}, seed {}: {:.3g} ({:.3g} before) after {} trials, {}", run.world,
                       run.arm, run.seed, run.confirmed, run.score, run.evaluations,
                       pretty_time(run.seconds));
}

class CompareSubcommand final : public Subcommand {
public:
    void add_options(CLI::App& app) override {
        app.add_option(
               "arms", options_.arms,
               "Settings files to compare, of which the first is the reference; the worlds' own "
               "settings by default")
            ->type_name(option_type::kSettings);
        app.add_option(
               "-w,--world", options_.worlds,
               "Settings file of a world to compare in, of which each arm changes only its own "
               "settings; may be given several times")
            ->type_name(option_type::kSettings)
            ->allow_extra_args(false);
        app.add_option("--set", options_.sets,
                       "Value of a setting in all arms, as selection.survival=0.1; may be given "
                       "several times")
            ->type_name("KEY=VALUE")
            ->allow_extra_args(false);
        app.add_option("--sweep", options_.sweep,
                       "Values of a setting, each of which makes one arm of every settings file")
            ->type_name("KEY=VALUE,VALUE...");
        app.add_flag(
            "--random-search", options_.random_search,
            "Random search as a further arm, which keeps the best of new random creatures");
        app.add_option("--museum", options_.museum,
                       "Folder of champions from which runs take the share [population] museum of "
                       "their founders")
            ->type_name(option_type::kFolder);
        app.add_option("-s,--seeds", options_.seeds, "Seeds of the runs, as 1..9 or 1..9,12")
            ->capture_default_str();
        take_whole(*app.add_option("-n,--trials", options_.trials,
                                   "Number of trials of each run, which ends with a generation")
                        ->capture_default_str(),
                   1, 1'000'000'000);
        take_whole(*app.add_option("-t,--threads", options_.threads,
                                   "Number of runs at the same time; one per core by default"),
                   1, 1024);
        add_cluster_choice(app, options_.cluster);
        app.add_option("-o,--out", options_.out,
                       "Folder for runs.csv, report.md, curves and champions; runs that it already "
                       "contains are not repeated")
            ->type_name(option_type::kFolder)
            ->capture_default_str();
    }
    CommandFiles files() const override {
        CommandFiles files;
        for (const auto* inputs : {&options_.arms, &options_.worlds}) {
            for (const std::string& input : *inputs)
                files.reads(input);
        }
        add_login_files(files, options_.cluster);
        return files.fills(options_.out);
    }
    bool works_in_space() const override { return true; }
    // Arms change some settings of the worlds, whatever the dimensions of those are.
    std::vector<std::filesystem::path> worlds() const override {
        const std::vector<std::string>& all =
            options_.worlds.empty() ? options_.arms : options_.worlds;
        return {all.begin(), all.end()};
    }
    ExitStatus run(const EvolutionKinds& kinds) override {
        if (options_.arms.empty() && options_.worlds.empty())
            return fail({"expected settings files to compare, or --world FILE"});
        auto runs = runs_of(options_, kinds);
        if (!runs) return fail(runs.error());
        const auto making = backend_making(options_.cluster, kinds);
        if (!making) return fail(making.error());
        const auto comparison = Comparison::open(options_.out, *std::move(runs), kinds);
        if (!comparison) return fail(comparison.error());
        const Interruption interruption;
        if (const Status ran = run_all(**comparison, *making, interruption); !ran)
            return fail(ran.error(), ExitStatus::kFailed);
        const ExitStatus told = tell((*comparison)->finished());
        if (!interruption.requested()) return told;
        say("interrupted; the same command continues with the missing runs");
        return ExitStatus::kFailed;
    }

private:
    Status run_all(Comparison& comparison, const BackendMaking& making,
                   const Interruption& interruption) const {
        if (comparison.missing() == 0) return {};
        say(counted(comparison.missing(), "run") + " to do");
        const Stopwatch watch;
        ProgressLine line([&] {
            const double share = comparison.share_done();
            return bar_text(share) + time_left_text(share, watch.seconds());
        });
        return comparison.run(
            options_.threads.value_or(ThreadPool::default_workers()), making,
            [&](const ComparedRun& run) { line.interrupt([&] { say(run_line(run)); }); },
            interruption.token());
    }

    ExitStatus tell(const std::vector<ComparedRun>& runs) const {
        if (runs.empty()) return ExitStatus::kFailed;
        const std::filesystem::path folder = options_.out;
        const std::string report = comparison_report(runs);
        if (const Status written = write_file(folder / kReportFile, report); !written)
            return fail(written.error(), ExitStatus::kFailed);
        if (const Status drawn = save_comparison_pictures(folder, runs); !drawn)
            say(drawn.error().message);
        return print_result(report);
    }

    CompareOptions options_;
};

}  // namespace

SubcommandKind compare_subcommand() {
    return {
        .id = "compare",
        .summary =
            "Compare settings: evolve with each of them and test whether their scores differ by "
            "more than chance.",
        .example =
            "cambrian compare --world assets/settings/walking.toml --sweep "
            "selection.method=truncation,rank --random-search --seeds 1..9 --out comparison/",
        .make = make_subcommand<CompareSubcommand>};
}

}  // namespace cambrian
