#include "app/evolve/without_window.h"

#include "app/command_line/option_types.h"
#include "app/evolve/evolution_run.h"
#include "app/process/messages.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

namespace cambrian {

void WithoutWindow::add_options(CLI::App& app) {
    app.add_option("--if-no-display", settings_,
                   "Settings file to evolve without a window if none can be opened")
        ->type_name(option_type::kSettings);
}

ExitStatus WithoutWindow::run(const Error& reason, const EvolutionKinds& kinds) const {
    if (settings_.empty()) {
        say(reason.message + "; `cambrian evolve SETTINGS.toml` works without a window");
        return ExitStatus::kFailed;
    }
    say(fmt::format("{}; evolving {} without a window", reason.message, settings_));
    EvolutionRun run;
    run.settings_file = settings_;
    return run_evolution(run, kinds);
}

}  // namespace cambrian
