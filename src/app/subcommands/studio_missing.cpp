// Replaces the studio's subcommand in a program built without its window.
#include "app/evolve/without_window.h"
#include "app/subcommands/subcommands.h"

#include <CLI/CLI.hpp>

namespace cambrian {
namespace {

class MissingStudio final : public Subcommand {
public:
    void add_options(CLI::App& app) override {
        app.allow_extras();  // options and files of the window
        without_window_.add_options(app);
    }
    ExitStatus run(const EvolutionKinds& kinds) override {
        return without_window_.run({"this program was built without its window"}, kinds);
    }

private:
    WithoutWindow without_window_;
};

}  // namespace

SubcommandKind studio_subcommand() {
    return {.id = "studio",
            .summary = "Open the studio; this program was built without it.",
            .example = "cambrian studio --if-no-display assets/settings/walking.toml",
            .make = make_subcommand<MissingStudio>};
}

}  // namespace cambrian
