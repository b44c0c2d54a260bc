#include "app/command_line/number_checks.h"
#include "app/command_line/option_types.h"
#include "app/command_line/output_path.h"
#include "app/page/page_making.h"
#include "app/process/long_work.h"
#include "app/process/messages.h"
#include "app/subcommands/subcommands.h"
#include "core/threads/thread_pool.h"
#include "evolution/backends/thread_pool_backend.h"
#include "evolution/evolution.h"
#include "evolution/individual/population_digest.h"
#include "persist/settings/settings_file.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <optional>
#include <string>
#include <vector>

namespace cambrian {
namespace {

constexpr int kCheckedGenerations = 3;  // whose digests a page of an evolution has

class PageSubcommand final : public Subcommand {
public:
    void add_options(CLI::App& app) override {
        auto* creatures =
            app.add_option("creatures", creatures_,
                           "Creature files (*.creature.json) or cards (*.card.png), at most 24, or "
                           "an experiment (*.cambrian), whose champions are shown")
                ->type_name(option_type::kCreatureOrExperiment);
        auto* evolve =
            app.add_option("--evolve", settings_,
                           "Settings file (*.toml) of an evolution that runs in the page")
                ->type_name(option_type::kSettings)
                ->excludes(creatures);
        take_whole(*app.add_option("--seed", seed_, "Seed of that evolution")->needs(evolve), 0,
                   1'000'000'000);
        app.add_option("-o,--out", out_, "Page to write (*.html)")
            ->type_name(option_type::kPage)
            ->required();
    }
    CommandFiles files() const override {
        CommandFiles files;
        for (const std::string& creature : creatures_)
            files.reads(creature);
        return files.reads(settings_).writes(out_, output_form::kPage);
    }
    bool works_in_space() const override { return true; }
    ExitStatus run(const EvolutionKinds& kinds) override {
        if (creatures_.empty() && settings_.empty())
            return fail({"expected a creature, an experiment or --evolve SETTINGS.toml"});
        if (settings_.empty()) return make_page_of(creatures_, out_, files(), kinds);
        const auto path = output_path(out_, "", files());
        if (!path) return fail(path.error());
        LongWork work;
        const Result<PageContent> content = with_evolution(kinds, work);
        if (!content) return fail(content.error());
        return write_page(*content, *path, kinds);
    }

private:
    // The digests of the first generations let the page prove that it evolves what the program
    // does.
    Result<PageContent> with_evolution(const EvolutionKinds& kinds, LongWork& work) const {
        Result<ExperimentSettings> settings = load_settings(settings_, kinds);
        if (!settings) return settings.error();
        if (seed_) settings->seed = *seed_;
        if (settings->population.museum > 0.0)
            return Error{settings_ +
                         ": [population] museum: expected 0, since a page has no museum"};
        PageContent content;
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

    std::vector<std::string> creatures_;
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
