#include "pictures/race.h"

#include "app/command_line/number_checks.h"
#include "app/command_line/option_types.h"
#include "app/command_line/output_path.h"
#include "app/process/long_work.h"
#include "app/process/messages.h"
#include "app/subcommands/subcommands.h"
#include "app/trial/creature_world.h"
#include "app/trial/movie_options.h"
#include "core/text/pretty_text.h"
#include "pictures/workshop.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <algorithm>
#include <optional>

namespace cambrian {
namespace {

// Returns the title of a creature without a name: the name of its file.
std::string title_of_runner(const std::string& file) {
    const std::string name = std::filesystem::path(file).filename().string();
    return capitalized(name.substr(0, name.find('.')));
}

class RaceSubcommand final : public Subcommand {
public:
    void add_options(CLI::App& app) override {
        app.add_option("creatures", creatures_,
                       "Creature files (*.creature.json) or cards (*.card.png), two to six")
            ->type_name(option_type::kCreature)
            ->required();
        add_movie_options(app, options_);
        take_real(*app.add_option("--seconds", seconds_,
                                  "Duration of the race, in seconds from the start of the trial; "
                                  "the complete trial by default"),
                  0.1, 86400.0);
        app.add_option("-e,--environment", environment_,
                       "Settings file whose world is used instead of the first creature's own")
            ->type_name(option_type::kSettings);
    }
    CommandFiles files() const override {
        CommandFiles files;
        for (const std::string& creature : creatures_)
            files.reads(creature);
        return files.reads(environment_).writes(options_.out, output_form::kClip);
    }
    bool works_in_space() const override { return true; }
    ExitStatus run(const EvolutionKinds& kinds) override {
        if (creatures_.size() < kLeastRunners || creatures_.size() > kMostRunners)
            return fail({fmt::format("{} creatures; expected {} to {}", creatures_.size(),
                                     kLeastRunners, kMostRunners)});
        const auto path = output_path(options_.out, "", files());
        if (!path) return fail(path.error());
        Result<MovieOrder> order = movie_order(options_, *path);
        if (!order) return fail(order.error());
        LongWork work;
        work.begin("simulating", static_cast<double>(creatures_.size()), "creatures");
        auto runners = runners_in_one_world(kinds, work);
        if (!runners) return fail(runners.error());
        const Race race(*std::move(runners));
        ClipTiming& timing = order->clip.timing;
        timing.seconds = std::min(seconds_.value_or(race.length()), race.length());
        const auto workshop = open_workshop(order->width, order->height);
        if (!workshop) return fail(workshop.error(), ExitStatus::kFailed);
        work.begin("drawing", timing.seconds / timing.speed);
        const Status made = write_race(*(*workshop)->canvas, race, order->clip, work.watch());
        return made ? ExitStatus::kDone : fail(made.error(), ExitStatus::kFailed);
    }

private:
    Result<std::vector<Subject>> runners_in_one_world(const EvolutionKinds& kinds,
                                                      LongWork& work) const {
        std::optional<ExperimentSettings> world;
        std::vector<Subject> runners;
        for (const std::string& file : creatures_) {
            const auto document = load_creature(file, kinds);
            if (!document) return document.error();
            say_of(file, document->warnings);
            if (!world) {
                auto settings = world_of(*document, environment_, kinds);
                if (!settings) return settings.error();
                world = *std::move(settings);
            }
            auto runner =
                subject_of(*document, *world, title_of_runner(file), kinds, {.stop = work.stop()});
            if (!runner) return runner.error();
            runners.push_back(*std::move(runner));
        }
        return runners;
    }

    std::vector<std::string> creatures_;
    MovieOptions options_;
    std::string environment_;
    std::optional<double> seconds_;
};

}  // namespace

SubcommandKind race_subcommand() {
    return {.id = "race",
            .summary = "Make a clip of a race of creatures in the same world, each in its lane.",
            .example =
                "cambrian race assets/creatures/biped.creature.json "
                "assets/creatures/walker.creature.json -o race.mp4",
            .make = make_subcommand<RaceSubcommand>};
}

}  // namespace cambrian
