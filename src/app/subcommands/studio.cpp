#include "app/evolution_run.h"
#include "app/messages.h"
#include "app/subcommands/subcommands.h"
#include "app/window.h"

#include <CLI/CLI.hpp>

namespace cambrian {
namespace {

class StudioSubcommand final : public Subcommand {
public:
    void add_options(CLI::App& app) override {
        app.add_option("file", window_.file, "Creature or settings file to open");
        app.add_option("--if-no-display", settings_without_,
                       "Where no window can be opened, evolve these settings instead");
        app.add_option("--status-log", window_.status_log,
                       "Write what goes on to this file, one JSON object a line");
        app.add_option("--frame-log", window_.frame_log,
                       "Write the time of every frame to this file");
    }
    ExitStatus run(const EvolutionKinds& kinds) override {
        const Status display = display_status();
        if (display) return run_window(window_, kinds);
        if (settings_without_.empty()) {
            return fail({display.error().message +
                         "; `cambrian evolve SETTINGS.toml` works without a window"},
                        ExitStatus::kFailed);
        }
        say(display.error().message + "; evolving " + settings_without_ + " instead");
        EvolutionRun instead;
        instead.settings_file = settings_without_;
        return run_evolution(instead, kinds);
    }

private:
    WindowOptions window_;
    std::string settings_without_;
};

}  // namespace

SubcommandKind studio_subcommand() {
    return {.id = "studio",
            .summary = "Open the studio: watch, steer and pick while creatures evolve.",
            .example = "cambrian studio champion-walking-seed7.creature.json",
            .make = []() -> std::unique_ptr<Subcommand> {
                return std::make_unique<StudioSubcommand>();
            }};
}

}  // namespace cambrian
