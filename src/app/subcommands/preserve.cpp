#include "app/command_line/number_checks.h"
#include "app/command_line/option_types.h"
#include "app/command_line/seed_list.h"
#include "app/preserve/preserve_run.h"
#include "app/subcommands/subcommands.h"

#include <CLI/CLI.hpp>

namespace cambrian {
namespace {

constexpr double kMostSeconds = 1e8;

class PreserveSubcommand final : public Subcommand {
public:
    void add_options(CLI::App& app) override {
        auto* settings = app.add_option("settings", run_.settings_file,
                                        "Settings file (*.toml) with a table [preserve]")
                             ->type_name(option_type::kSettings);
        take_real(
            *app.add_option("--seconds", run_.seconds,
                            "Time of the preserve at which to stop; until Ctrl+C unless given"),
            0.0, kMostSeconds);
        auto* founders = app.add_option("-f,--founders", run_.founders,
                                        "Creature files to begin with instead of random creatures")
                             ->type_name(option_type::kCreature);
        auto* seed = app.add_option("-s,--seed", run_.seed, "Seed, instead of the file's");
        take_whole(*seed, 0, kMostSeed);
        take_whole(*app.add_option("-t,--threads", run_.threads,
                                   "Threads; one a core unless given. Never changes a result"),
                   1, 1024);
        auto* out = app.add_option("-o,--out", run_.out, "Preserve file to keep (*.cambrian)")
                        ->type_name(option_type::kExperiment);
        auto* resume = app.add_option("-r,--resume", run_.resume,
                                      "Go on with a preserve file, to the time given")
                           ->type_name(option_type::kExperiment)
                           ->excludes(settings, seed, founders, out);
        app.add_option("--law", run_.laws,
                       "Law of the resumed preserve that changes now, as preserve.growth-time=60; "
                       "may be given several times")
            ->type_name("KEY=VALUE")
            ->allow_extra_args(false)
            ->needs(resume);
        app.add_flag("--json", run_.json,
                     "Report as JSON, one object a line for each 10 s of its time");
    }
    CommandFiles files() const override { return files_of(run_); }
    ExitStatus run(const EvolutionKinds& kinds) override { return run_preserve(run_, kinds); }

private:
    PreserveRun run_;
};

}  // namespace

SubcommandKind preserve_subcommand() {
    return {
        .id = "preserve",
        .summary =
            "Let creatures feed, hunt, breed and die by themselves in a closed world, without "
            "a window.",
        .example = "cambrian preserve assets/settings/pond.toml --seconds 600 --out pond.cambrian",
        .make = make_subcommand<PreserveSubcommand>};
}

}  // namespace cambrian
