#include "app/command_line/number_checks.h"
#include "app/command_line/option_types.h"
#include "app/command_line/output_path.h"
#include "app/preserve/museum_export.h"
#include "app/process/long_work.h"
#include "app/process/messages.h"
#include "app/subcommands/subcommands.h"
#include "core/files/file_io.h"
#include "genome/creature_name.h"
#include "persist/creature/creature_file.h"
#include "persist/experiment/experiment_parts.h"
#include "persist/preserve/preserve_file.h"
#include "persist/records/statistics_csv.h"
#include "persist/settings/settings_file.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace cambrian {
namespace {

class ExportSubcommand final : public Subcommand {
public:
    void add_options(CLI::App& app) override {
        app.add_option("experiment", file_, "Experiment or preserve file (*.cambrian)")
            ->type_name(option_type::kExperiment)
            ->required();
        auto* champion = app.add_flag("--champion", champion_, "Champion of the last generation");
        auto* generation =
            app.add_option("-g,--generation", generation_,
                           "Number of the generation whose best creature is exported")
                ->excludes(champion);
        take_whole(*generation, 0, 10'000'000);
        auto* stats = app.add_flag("--stats", stats_, "Statistics of every generation, as CSV")
                          ->excludes(champion, generation);
        auto* settings = app.add_flag("--settings", settings_, "Settings of the last generation")
                             ->excludes(champion, generation, stats);
        auto* lives = app.add_flag("--lives", lives_, "All lives of a preserve, as CSV")
                          ->excludes(champion, generation, stats, settings);
        auto* series = app.add_flag("--series", series_, "Series of a preserve, as CSV")
                           ->excludes(champion, generation, stats, settings, lives);
        app.add_flag("--museum", museum_,
                     "Museum of a preserve, as creature files in the folder --out")
            ->excludes(champion, generation, stats, settings, lives, series);
        app.add_option("-o,--out", out_,
                       "File to write, standard output by default; with --museum a folder")
            ->type_name(option_type::kFile);
    }
    CommandFiles files() const override {
        CommandFiles files;
        files.reads(file_);
        if (museum_) return files.fills(out_);
        return files.writes(out_, settings_                  ? output_form::kSettings
                                  : champion_ || generation_ ? output_form::kCreature
                                                             : output_form::kTable);
    }
    bool works_in_space() const override { return true; }
    ExitStatus run(const EvolutionKinds& kinds) override {
        if (!champion_ && !generation_ && !stats_ && !settings_ && !lives_ && !series_ && !museum_)
            return fail(
                {"expected --champion, --generation G, --stats or --settings of an "
                 "experiment, or --lives, --series or --museum of a preserve"});
        if (museum_) return write_museum(kinds);
        // This must fail before the work begins, so that no result is lost.
        const Result<std::filesystem::path> path =
            out_.empty() ? std::filesystem::path() : output_path(out_, "", files());
        if (!path) return fail(path.error());
        LongWork work;
        const Result<std::string> text = text_of(kinds, work);
        if (!text) return fail(text.error());
        if (out_.empty()) return print_result(*text);
        const Status written = write_file(*path, *text);
        return written ? ExitStatus::kDone : fail(written.error(), ExitStatus::kFailed);
    }

private:
    ExitStatus write_museum(const EvolutionKinds& kinds) const {
        if (out_.empty()) return fail({"--museum needs a folder to write to: --out FOLDER"});
        const Result<std::string> names = export_museum(file_, out_, kinds);
        return names ? print_result(*names) : fail(names.error());
    }

    Result<std::string> text_of(const EvolutionKinds& kinds, LongWork& work) const {
        if (lives_) return lives_csv(file_);
        if (series_) return series_csv(file_);
        if (settings_) {
            const Result<SettingsPtr> settings = load_last_settings(file_, kinds);
            return settings ? Result(write_settings(**settings, kinds)) : settings.error();
        }
        if (stats_) {
            const auto history = load_history(file_);
            return history ? Result(statistics_csv(*history)) : history.error();
        }
        return champion_text(kinds, work);
    }

    Result<std::string> champion_text(const EvolutionKinds& kinds, LongWork& work) const {
        const Result<KeptChampion> kept = load_champion(file_, generation_, kinds);
        if (!kept) return kept.error();
        const JudgedIndividual& champion = kept->creature;
        CreatureDocument document = creature_document(champion, kinds);
        document.notes.simulator = kept->simulator;
        work.begin("computing more finely", champion.settings->world.trial.duration);
        complete_score(document, kinds, work.stop());
        if (work.interrupted()) return Error{"interrupted; nothing was written"};
        if (!out_.empty())
            say(fmt::format("{}, born in generation {}",
                            creature_name(*champion.individual->genome),
                            champion.individual->born));
        return write_creature(document, kinds);
    }

    std::string file_;
    std::string out_;
    std::optional<std::uint32_t> generation_;
    bool champion_ = false;
    bool stats_ = false;
    bool settings_ = false;
    bool lives_ = false;
    bool series_ = false;
    bool museum_ = false;
};

}  // namespace

SubcommandKind export_subcommand() {
    return {
        .id = "export",
        .summary = "Take creatures, statistics or settings out of an experiment or preserve file.",
        .example = "cambrian export walking-seed1.cambrian --champion -o best.creature.json",
        .make = make_subcommand<ExportSubcommand>};
}

}  // namespace cambrian
