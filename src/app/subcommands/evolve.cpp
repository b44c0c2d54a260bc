#include "app/evolution_run.h"
#include "app/option_types.h"
#include "app/subcommands/subcommands.h"

#include <CLI/CLI.hpp>

namespace cambrian {
namespace {

class EvolveSubcommand final : public Subcommand {
public:
    void add_options(CLI::App& app) override {
        app.add_option("settings", run_.settings_file, "Settings file (*.toml)")
            ->type_name(option_type::kSettings)
            ->required();
        app.add_option("-n,--generations", run_.generations, "Generations, instead of the file's")
            ->check(CLI::Range(1, 1'000'000));
        app.add_option("-s,--seed", run_.seed, "Seed, instead of the file's");
        app.add_option("-f,--founders", run_.founders,
                       "Creature files to begin with instead of random creatures")
            ->type_name(option_type::kCreature);
        app.add_option("-t,--threads", run_.threads,
                       "Threads; one a core unless given. Never changes a result")
            ->check(CLI::Range(1, 1024));
        app.add_option("-o,--out", run_.out,
                       "File of the champion, or the folder it goes into (current folder)")
            ->type_name(option_type::kCreature);
        app.add_flag("--json", run_.json, "Report as JSON, one object a line");
    }
    ExitStatus run(const EvolutionKinds& kinds) override { return run_evolution(run_, kinds); }

private:
    EvolutionRun run_;
};

}  // namespace

SubcommandKind evolve_subcommand() {
    return {.id = "evolve",
            .summary =
                "Evolve without a window and keep the champion. Ctrl+C finishes the "
                "generation and keeps the champion so far.",
            .example =
                "cambrian evolve assets/settings/walking.toml --generations 30 --seed 7 "
                "--out champions/",
            .make = []() -> std::unique_ptr<Subcommand> {
                return std::make_unique<EvolveSubcommand>();
            }};
}

}  // namespace cambrian
