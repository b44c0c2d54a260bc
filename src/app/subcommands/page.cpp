#include "app/command_line/number_checks.h"
#include "app/command_line/option_types.h"
#include "app/command_line/output_path.h"
#include "app/process/assets_folder.h"
#include "app/process/long_work.h"
#include "app/process/messages.h"
#include "app/subcommands/subcommands.h"
#include "core/files/file_io.h"
#include "core/threads/thread_pool.h"
#include "evolution/backends/thread_pool_backend.h"
#include "evolution/evolution.h"
#include "evolution/individual/population_digest.h"
#include "genome/creature_name.h"
#include "persist/experiment/experiment_parts.h"
#include "persist/page/page_file.h"
#include "persist/settings/settings_file.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <algorithm>
#include <set>

namespace cambrian {
namespace {

constexpr std::size_t kMostChampions = 12;  // on a page of a run
constexpr int kCheckedGenerations = 3;      // whose digests a page of an evolution has

// The installed engine lies beside the scripts, that of a build in the build's folder.
PageParts page_parts() {
    PageParts parts;
    parts.folder = assets_folder() / "page";
    const std::filesystem::path built = CAMBRIAN_ENGINE_FOLDER;
    std::error_code failure;
    const bool installed = std::filesystem::exists(parts.folder / "cambrian.wasm", failure);
    const std::filesystem::path& folder = installed ? parts.folder : built;
    parts.engine = folder / "cambrian.wasm";
    parts.licences = folder / "licences.txt";
    return parts;
}

// Generations spread over a run, the last one first.
std::vector<std::uint32_t> chosen_generations(std::uint32_t last) {
    std::set<std::uint32_t> chosen;
    for (std::size_t i = 0; i < kMostChampions; ++i)
        chosen.insert(static_cast<std::uint32_t>(last * i / (kMostChampions - 1)));
    return {chosen.rbegin(), chosen.rend()};
}

class PageSubcommand final : public Subcommand {
public:
    void add_options(CLI::App& app) override {
        auto* creature = app.add_option("creature", creature_,
                                        "Creature file (*.creature.json), card (*.card.png) or "
                                        "experiment (*.cambrian), whose champions are shown")
                             ->type_name(option_type::kCreatureOrExperiment);
        auto* evolve =
            app.add_option("--evolve", settings_,
                           "Settings file (*.toml) of an evolution that runs in the page")
                ->type_name(option_type::kSettings)
                ->excludes(creature);
        take_whole(*app.add_option("--seed", seed_, "Seed of that evolution")->needs(evolve), 0,
                   1'000'000'000);
        app.add_option("-o,--out", out_, "Page to write (*.html)")
            ->type_name(option_type::kPage)
            ->required();
    }
    CommandFiles files() const override {
        return CommandFiles().reads(creature_).reads(settings_).writes(out_, output_form::kPage);
    }
    bool works_in_space() const override { return true; }
    ExitStatus run(const EvolutionKinds& kinds) override {
        if (creature_.empty() && settings_.empty())
            return fail({"expected a creature, an experiment or --evolve SETTINGS.toml"});
        const auto path = output_path(out_, "", files());
        if (!path) return fail(path.error());
        LongWork work;
        const Result<PageContent> content = content_of_page(kinds, work);
        if (!content) return fail(content.error());
        const PageParts parts = page_parts();
        const Result<std::string> page = make_page(*content, parts, kinds);
        if (!page) return fail(page.error(), ExitStatus::kFailed);
        const Status written = write_file(*path, *page);
        if (!written) return fail(written.error(), ExitStatus::kFailed);
        if (!std::filesystem::exists(parts.engine))
            say("no engine is built, so the page plays recorded motions only; `sh "
                "third_party/bootstrap.sh engine` builds it");
        return print_result_line(fmt::format("{}: {} kB", path->string(), page->size() / 1000));
    }

private:
    Result<PageContent> content_of_page(const EvolutionKinds& kinds, LongWork& work) const {
        PageContent content{.title = {}, .version = CAMBRIAN_VERSION, .creatures = {}};
        if (!settings_.empty()) return with_evolution(std::move(content), kinds, work);
        if (is_experiment_name(creature_)) return with_champions(std::move(content), kinds, work);
        Result<CreatureDocument> document = load_creature(creature_, kinds);
        if (!document) return document.error();
        say_of(creature_, document->warnings);
        content.title = creature_name(document->genome());
        content.creatures.push_back({.document = std::move(*document), .label = content.title});
        return content;
    }

    Result<PageContent> with_champions(PageContent content, const EvolutionKinds& kinds,
                                       LongWork& work) const {
        const auto history = load_history(creature_);
        if (!history) return history.error();
        content.title = "Champions of " + std::filesystem::path(creature_).stem().string();
        const auto generations = chosen_generations(history->back().generation);
        work.begin("computing champions", static_cast<double>(generations.size()), "creatures");
        for (const std::uint32_t generation : generations) {
            const Result<KeptChampion> kept = load_champion(creature_, generation, kinds);
            if (!kept) return kept.error();
            PageCreature shown{.document = creature_document(kept->creature, kinds),
                               .label = fmt::format("generation {}", generation)};
            shown.document.notes.simulator = kept->simulator;
            complete_score(shown.document, kinds, work.stop());
            if (work.interrupted()) return Error{"interrupted; nothing was written"};
            content.creatures.push_back(std::move(shown));
        }
        return content;
    }

    // The digests of the first generations let the page prove that it evolves what the program
    // does.
    Result<PageContent> with_evolution(PageContent content, const EvolutionKinds& kinds,
                                       LongWork& work) const {
        Result<ExperimentSettings> settings = load_settings(settings_, kinds);
        if (!settings) return settings.error();
        if (seed_) settings->seed = *seed_;
        content.title = fmt::format("Evolve {}", settings->goal);
        PageEvolution offered{.settings = *settings, .digests = {}};
        const auto backend = make_thread_pool_backend(kinds, ThreadPool::default_workers());
        Evolution evolution(std::make_shared<const ExperimentSettings>(*settings), kinds);
        work.begin("evolving", kCheckedGenerations, "generations");
        for (int generation = 0; generation < kCheckedGenerations; ++generation) {
            EvaluationProgress progress;
            if (!evolution.evaluate(*backend, progress, work.stop()))
                return Error{"interrupted; nothing was written"};
            offered.digests.push_back(population_digest(evolution.population()));
            evolution.breed();
        }
        content.evolution = std::move(offered);
        return content;
    }

    std::string creature_;
    std::string settings_;
    std::string out_;
    std::optional<std::uint64_t> seed_;
};

}  // namespace

SubcommandKind page_subcommand() {
    return {.id = "page",
            .summary = "Make a page for a browser on which a creature lives or evolution runs.",
            .example = "cambrian page assets/creatures/walker.creature.json -o walker.html",
            .make = make_subcommand<PageSubcommand>};
}

}  // namespace cambrian
