#include "app/command_line/option_types.h"
#include "app/command_line/output_path.h"
#include "app/process/messages.h"
#include "app/subcommands/subcommands.h"
#include "core/files/file_io.h"
#include "persist/settings/settings_file.h"
#include "persist/text/quoted_text.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

namespace cambrian {
namespace {

class SettingsSubcommand final : public Subcommand {
public:
    void add_options(CLI::App& app) override {
        app.add_option(
               "settings", file_,
               "Settings file to complete; what it lacks, and all without a file, has its default")
            ->type_name(option_type::kSettings);
        app.add_option("-g,--goal", goal_, "Goal of the settings, with the environment it needs")
            ->default_str(ExperimentSettings().goal)
            ->excludes("settings");
        app.add_flag("--preserve", preserve_, "Settings of a preserve instead of an experiment")
            ->excludes("--goal");
        app.add_option(
               "-o,--out", out_,
               "File to write, or folder of a file named after the goal; standard output by "
               "default")
            ->type_name(option_type::kSettings);
    }
    CommandFiles files() const override {
        return CommandFiles().reads(file_).writes(out_, output_form::kSettings);
    }
    bool works_in_space() const override { return true; }
    ExitStatus run(const EvolutionKinds& kinds) override {
        const SettingsUse use = preserve_ ? SettingsUse::kPreserve : SettingsUse::kExperiment;
        const Result<ExperimentSettings> settings =
            file_.empty() ? parse_settings(starting_text(), "--goal", kinds, use)
                          : load_settings(file_, kinds, use);
        if (!settings) return fail(settings.error());
        const std::string text = write_settings(*settings, kinds, use);
        if (out_.empty()) return print_result(text);
        const auto path = output_path(
            out_, (preserve_ ? std::string("preserve") : settings->goal) + ".toml", files());
        if (!path) return fail(path.error());
        const Status written = write_file(*path, text);
        return written ? ExitStatus::kDone : fail(written.error(), ExitStatus::kFailed);
    }

private:
    std::string starting_text() const {
        return goal_.empty() ? "" : fmt::format("[goal]\nbehavior = {}\n", quoted_text(goal_));
    }

    std::string file_;
    std::string goal_;
    std::string out_;
    bool preserve_ = false;
};

}  // namespace

SubcommandKind settings_subcommand() {
    return {.id = "settings",
            .summary = "Write a settings file with every setting, its unit, range and meaning.",
            .example = "cambrian settings --goal swimming --out swimming.toml",
            .make = make_subcommand<SettingsSubcommand>};
}

}  // namespace cambrian
