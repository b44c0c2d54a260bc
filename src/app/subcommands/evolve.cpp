#include "app/cluster/cluster_options.h"
#include "app/command_line/number_checks.h"
#include "app/command_line/option_types.h"
#include "app/command_line/seed_list.h"
#include "app/evolve/evolution_run.h"
#include "app/process/messages.h"
#include "app/subcommands/subcommands.h"

#include <CLI/CLI.hpp>

#include <optional>

namespace cambrian {
namespace {

class EvolveSubcommand final : public Subcommand {
public:
    void add_options(CLI::App& app) override {
        auto* settings =
            app.add_option("settings", run_.settings_file,
                           "Settings file (*.toml) of the run; required unless --resume is given")
                ->type_name(option_type::kSettings);
        take_whole(*app.add_option("-n,--generations", run_.generations,
                                   "Number of generations, instead of the file's"),
                   1, 1'000'000);
        auto* seed =
            app.add_option("-s,--seed", seed_, "Seed of all random numbers, instead of the file's");
        take_whole(*seed, 0, kMostSeed);
        auto* seeds =
            app.add_option("--seeds", seeds_,
                           "Seeds of several runs, one after the other, as 1..9 or 1..9,12")
                ->excludes(seed);
        app.add_option("--set", run_.sets,
                       "Value of a setting instead of the file's, as "
                       "selection.method=rank; with --resume from the next generation "
                       "on; may be given several times")
            ->type_name("KEY=VALUE")
            ->allow_extra_args(false);
        auto* founders = app.add_option("-f,--founders", run_.founders,
                                        "Creature files of founders, which replace random ones")
                             ->type_name(option_type::kCreature);
        app.add_option("--museum", run_.museum,
                       "Folder of champions that gives the share [population] museum of the "
                       "founders, and takes the run's champion if its body plan is new")
            ->type_name(option_type::kFolder);
        take_whole(
            *app.add_option("-t,--threads", run_.threads,
                            "Number of threads, which has no influence on results; one per core "
                            "by default"),
            1, 1024);
        app.add_option("-o,--out", run_.out,
                       "Experiment file (*.cambrian) or creature file of the champion to write, or "
                       "folder for both; the current folder by default")
            ->type_name(option_type::kExperiment);
        auto* resume =
            app.add_option("-r,--resume", run_.resume,
                           "Experiment file to continue, up to its number of generations or that "
                           "of --generations")
                ->type_name(option_type::kExperiment)
                ->excludes(settings, seed, seeds, founders);
        app.add_option("--inject", run_.injected,
                       "Creature files whose creatures are bred into the next generation of the "
                       "experiment that --resume continues")
            ->type_name(option_type::kCreature)
            ->needs(resume);
        add_cluster_choice(app, run_.cluster);
        app.add_flag("--json", run_.json, "Output as JSON, one object per line");
    }
    CommandFiles files() const override { return files_of(run_); }
    bool works_in_space() const override { return true; }
    ExitStatus run(const EvolutionKinds& kinds) override {
        if (!seeds_.empty()) {
            auto seeds = parse_seeds(seeds_);
            if (!seeds) return fail({"--seeds: " + seeds.error().message});
            run_.seeds = *std::move(seeds);
        }
        if (seed_) run_.seeds = {*seed_};
        return run_evolution(run_, kinds);
    }

private:
    std::optional<std::uint64_t> seed_;
    std::string seeds_;
    EvolutionRun run_;
};

}  // namespace

SubcommandKind evolve_subcommand() {
    return {
        .id = "evolve",
        .summary =
            "Evolve without a window and save the experiment and its champion. Ctrl+C stops the "
            "run, which can be continued.",
        .example =
            "cambrian evolve assets/settings/walking.toml --generations 30 --seed 7 "
            "--out champions/",
        .make = make_subcommand<EvolveSubcommand>};
}

}  // namespace cambrian
