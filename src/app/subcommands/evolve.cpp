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
        auto* settings = app.add_option("settings", run_.settings_file, "Settings file (*.toml)")
                             ->type_name(option_type::kSettings);
        take_whole(*app.add_option("-n,--generations", run_.generations,
                                   "Generations, instead of the file's"),
                   1, 1'000'000);
        auto* seed = app.add_option("-s,--seed", seed_, "Seed, instead of the file's");
        take_whole(*seed, 0, kMostSeed);
        auto* seeds = app.add_option("--seeds", seeds_,
                                     "A run with each of these, one after the other, as 1..9 or "
                                     "1..9,12")
                          ->excludes(seed);
        auto* sets = app.add_option("--set", run_.sets,
                                    "A setting instead of the file's, as selection.method=rank; "
                                    "may be given again")
                         ->type_name("KEY=VALUE")
                         ->allow_extra_args(false);
        auto* founders = app.add_option("-f,--founders", run_.founders,
                                        "Creature files to begin with instead of random creatures")
                             ->type_name(option_type::kCreature);
        take_whole(*app.add_option("-t,--threads", run_.threads,
                                   "Threads; one a core unless given. Never changes a result"),
                   1, 1024);
        app.add_option("-o,--out", run_.out,
                       "Experiment file to keep (*.cambrian), file of the champion, or folder "
                       "for both (current folder)")
            ->type_name(option_type::kExperiment);
        app.add_option("-r,--resume", run_.resume,
                       "Go on with an experiment file, to the generations given")
            ->type_name(option_type::kExperiment)
            ->excludes(settings, seed, seeds, sets, founders);
        add_cluster_choice(app, run_.cluster);
        app.add_flag("--json", run_.json, "Report as JSON, one object a line");
    }
    CommandFiles files() const override { return files_of(run_); }
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
    return {.id = "evolve",
            .summary =
                "Evolve without a window; keep the experiment and its champion. Ctrl+C stops and "
                "says how to go on.",
            .example =
                "cambrian evolve assets/settings/walking.toml --generations 30 --seed 7 "
                "--out champions/",
            .make = make_subcommand<EvolveSubcommand>};
}

}  // namespace cambrian
