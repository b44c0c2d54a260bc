#include "app/builtin_kinds.h"
#include "app/command_line/option_types.h"
#include "app/command_line/window_options.h"
#include "app/page/page_making.h"
#include "app/process/interruption.h"
#include "app/process/messages.h"
#include "app/subcommands/subcommands.h"
#include "persist/creature/creature_file.h"

#include <CLI/CLI.hpp>

namespace cambrian {
namespace {

class ViewSubcommand final : public Subcommand {
public:
    ViewSubcommand() {
        options_.viewer = true;
        options_.page_parts = page_parts();
        options_.machines.threads.workers = 1;
        options_.drawing.width = 960;
        options_.drawing.height = 640;
    }
    void add_options(CLI::App& app) override {
        app.add_option("creature", options_.open_file,
                       "Creature file (*.creature.json) or card (*.card.png)")
            ->type_name(option_type::kCreature)
            ->required();
        app.add_option("--theme", theme_, "Theme of the window")
            ->check(CLI::IsMember({"dark", "light"}))
            ->capture_default_str();
        add_window_options(app, options_);
    }
    CommandFiles files() const override { return window_files(options_).reads(options_.open_file); }
    bool works_in_space() const override { return true; }
    ExitStatus run(const EvolutionKinds& kinds) override {
        const auto document = load_creature(options_.open_file, kinds);
        if (!document) return fail(document.error());
        options_.theme = theme_ == "light" ? ThemeKind::kLight : ThemeKind::kDark;
        const Interruption interruption;
        options_.end = interruption.token();
        const Status shown = run_studio(options_, builtin_kinds(2), builtin_kinds(3));
        return shown ? ExitStatus::kDone : fail(shown.error(), ExitStatus::kFailed);
    }

private:
    StudioOptions options_;
    std::string theme_ = "dark";
};

}  // namespace

SubcommandKind view_subcommand() {
    return {.id = "view",
            .summary = "Watch one creature's trial: the window's viewport alone.",
            .example = "cambrian view champion-walking-seed7.creature.json",
            .make = make_subcommand<ViewSubcommand>};
}

}  // namespace cambrian
