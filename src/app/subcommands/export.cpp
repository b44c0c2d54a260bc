#include "app/messages.h"
#include "app/option_types.h"
#include "app/subcommands/subcommands.h"
#include "core/file_io.h"
#include "persist/creature_file.h"
#include "persist/experiment_file.h"
#include "persist/rescoring.h"
#include "persist/settings_file.h"
#include "persist/statistics_csv.h"

#include <CLI/CLI.hpp>

#include <optional>
#include <string>

namespace cambrian {
namespace {

class ExportSubcommand final : public Subcommand {
public:
    void add_options(CLI::App& app) override {
        app.add_option("experiment", file_, "Experiment file (*.cambrian)")
            ->type_name(option_type::kExperiment)
            ->required();
        auto* champion =
            app.add_flag("--champion", champion_, "The best creature of the last generation");
        auto* generation =
            app.add_option("-g,--generation", generation_, "The best creature of this generation")
                ->check(CLI::Range(0, 10'000'000))
                ->excludes(champion);
        auto* stats = app.add_flag("--stats", stats_, "Every generation's statistics, as CSV")
                          ->excludes(champion, generation);
        app.add_flag("--settings", settings_, "The settings of the last generation")
            ->excludes(champion, generation, stats);
        app.add_option("-o,--out", out_, "File to write; standard output unless given")
            ->type_name(option_type::kFile);
    }
    ExitStatus run(const EvolutionKinds& kinds) override {
        if (!champion_ && !generation_ && !stats_ && !settings_)
            return fail({"what to export: --champion, --generation G, --stats or --settings"});
        const Result<SavedExperiment> saved = load_experiment(file_, kinds);
        if (!saved) return fail(saved.error());
        const Result<std::string> text = text_of(*saved, kinds);
        if (!text) return fail(text.error());
        const Status written = write_file(out_.empty() ? "/dev/stdout" : out_, *text);
        return written ? ExitStatus::kDone : fail(written.error(), ExitStatus::kFailed);
    }

private:
    Result<std::string> text_of(const SavedExperiment& saved, const EvolutionKinds& kinds) const {
        if (settings_) return write_settings(*setting_changes(saved).back().settings, kinds);
        if (!saved.latest) return Error{file_ + ": no generation has been finished yet"};
        if (stats_) return statistics_csv(saved.latest->history);
        const std::size_t generation =
            generation_ ? static_cast<std::size_t>(*generation_) : saved.champions.size() - 1;
        if (generation >= saved.champions.size()) {
            return Error{file_ + ": has no generation " + std::to_string(generation) +
                         "; the last is " + std::to_string(saved.champions.size() - 1)};
        }
        const ChampionRecord& champion = saved.champions[generation];
        CreatureDocument document =
            creature_document(*champion.individual, *champion.settings, kinds);
        if (document.scored) {
            document.scored->simulator =
                scored_by(saved, champion.individual->born, champion.generation);
        }
        complete_score(document, kinds);
        return write_creature(document, kinds);
    }

    std::string file_;
    std::string out_;
    std::optional<int> generation_;
    bool champion_ = false;
    bool stats_ = false;
    bool settings_ = false;
};

}  // namespace

SubcommandKind export_subcommand() {
    return {.id = "export",
            .summary = "Take creatures, statistics or settings out of an experiment file.",
            .example = "cambrian export walking-seed1.cambrian --champion -o best.creature.json",
            .make = []() -> std::unique_ptr<Subcommand> {
                return std::make_unique<ExportSubcommand>();
            }};
}

}  // namespace cambrian
