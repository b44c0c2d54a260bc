#include "app/command_line/number_checks.h"
#include "app/command_line/option_types.h"
#include "app/command_line/output_path.h"
#include "app/process/long_work.h"
#include "app/process/messages.h"
#include "app/subcommands/subcommands.h"
#include "app/trial/creature_world.h"
#include "app/trial/lesion_report.h"
#include "core/files/file_io.h"
#include "core/threads/thread_pool.h"
#include "evolution/backends/thread_pool_backend.h"
#include "persist/creature/creature_file.h"
#include "persist/creature/pruned_twin.h"

#include <CLI/CLI.hpp>

#include <optional>
#include <string>

namespace cambrian {
namespace {

constexpr int kMostLesionWorlds = 101;

class LesionSubcommand final : public Subcommand {
public:
    void add_options(CLI::App& app) override {
        app.add_option("creature", creature_,
                       "Creature file (*.creature.json) or card (*.card.png)")
            ->type_name(option_type::kCreature)
            ->required();
        app.add_option("-e,--environment", environment_,
                       "Settings file whose environment and goal are used instead of the "
                       "creature's own")
            ->type_name(option_type::kSettings);
        take_whole(*app.add_option("--worlds", worlds_,
                                   "Number of slightly different worlds in which each lesion is "
                                   "tried; 11 by default"),
                   1, kMostLesionWorlds);
        app.add_flag("--pairs", pairs_, "Also inflict the ten worst lesions two at a time");
        app.add_option("--prune", prune_,
                       "Creature file to write: the same creature without the genes that cost it "
                       "nothing, with its own score")
            ->type_name("FILE.creature.json");
        app.add_option("--csv", csv_, "File for the table, as CSV")->type_name(option_type::kTable);
        take_whole(*app.add_option("-t,--threads", threads_,
                                   "Number of threads, which has no influence on results; one per "
                                   "core by default"),
                   1, 1024);
        app.add_flag("--json", json_, "Output as one JSON object");
    }
    CommandFiles files() const override {
        return CommandFiles()
            .reads(creature_)
            .reads(environment_)
            .writes(prune_, output_form::kCreature)
            .writes(csv_, output_form::kTable);
    }
    bool works_in_space() const override { return true; }
    ExitStatus run(const EvolutionKinds& kinds) override {
        const Result<CreatureDocument> document = load_creature(creature_, kinds);
        if (!document) return fail(document.error());
        say_of(creature_, document->warnings);
        const Result<ExperimentSettings> settings = world_of(*document, environment_, kinds);
        if (!settings) return fail(settings.error());
        const LesionStudy study{.genome = document->creature.individual->genome,
                                .settings = *settings,
                                .worlds = worlds_,
                                .pairs = pairs_};
        LongWork work;
        const auto backend = make_thread_pool_backend(
            kinds, threads_ ? static_cast<std::size_t>(*threads_) : ThreadPool::default_workers());
        EvaluationProgress progress;
        work.begin("inflicting lesions", 1, "creature");
        const auto table = lesion_table(study, kinds, *backend, progress, work.stop());
        if (!table) return fail({"interrupted; nothing was written"}, ExitStatus::kFailed);
        std::optional<PrunedCreature> twin;
        if (!prune_.empty()) {
            work.begin("pruning", 1, "creature");
            twin = pruned(study, kinds, *backend, progress, work.stop());
            if (!twin) return fail({"interrupted; nothing was written"}, ExitStatus::kFailed);
            const Status saved = save_twin(*twin, *document, *settings, kinds, work.stop());
            if (!saved) return fail(saved.error(), ExitStatus::kFailed);
        }
        return report(*table, twin, study, kinds);
    }

private:
    Status save_twin(const PrunedCreature& twin, const CreatureDocument& original,
                     const ExperimentSettings& settings, const EvolutionKinds& kinds,
                     const std::stop_token& stop) const {
        const auto path = output_path(prune_, "", files());
        if (!path) return path.error();
        const Result<CreatureDocument> document =
            pruned_twin(twin.genome, original, settings, kinds, stop);
        if (!document) return document.error();
        return save_creature(*path, *document, kinds);
    }

    ExitStatus report(const LesionTable& table, const std::optional<PrunedCreature>& twin,
                      const LesionStudy& study, const EvolutionKinds& kinds) const {
        const Phenotype intact = express(*study.genome, kinds.creature, study.settings.expression,
                                         study.settings.world.scene);
        const LesionReport told{table, intact, kinds.creature,
                                kinds.goals.find(study.settings.goal)->unit};
        if (!csv_.empty()) {
            const auto path = output_path(csv_, "", files());
            if (!path) return fail(path.error());
            const Status written = write_file(*path, lesions_csv(told));
            if (!written) return fail(written.error(), ExitStatus::kFailed);
        }
        if (json_) return print_result_line(lesions_json(told, twin ? &*twin : nullptr));
        return print_result_line(lesions_text(told) +
                                 (twin ? "\n" + pruning_text(*twin, told.unit) : ""));
    }

    std::string creature_;
    std::string environment_;
    std::string prune_;
    std::string csv_;
    std::optional<int> threads_;
    int worlds_ = kLesionWorlds;
    bool pairs_ = false;
    bool json_ = false;
};

}  // namespace

SubcommandKind lesion_subcommand() {
    return {.id = "lesion",
            .summary =
                "Find out what each part, joint, neuron, link and sensor does for a "
                "creature.",
            .example = "cambrian lesion walker.creature.json --prune pruned.creature.json",
            .make = make_subcommand<LesionSubcommand>};
}

}  // namespace cambrian
