#include "pictures/film.h"

#include "app/command_line/number_checks.h"
#include "app/command_line/option_types.h"
#include "app/command_line/output_path.h"
#include "app/process/long_work.h"
#include "app/process/messages.h"
#include "app/subcommands/subcommands.h"
#include "app/trial/movie_options.h"
#include "pictures/workshop.h"

#include <CLI/CLI.hpp>

namespace cambrian {
namespace {

class FilmSubcommand final : public Subcommand {
public:
    void add_options(CLI::App& app) override {
        app.add_option("run", run_, "Experiment file (*.cambrian)")
            ->type_name(option_type::kExperiment)
            ->required();
        add_movie_options(app, options_);
        take_real(*app.add_option("--seconds", seconds_,
                                  "Duration, in seconds of its trial, of what each champion shows")
                       ->default_str("3"),
                  0.1, 600.0);
    }
    CommandFiles files() const override {
        return CommandFiles().reads(run_).writes(options_.out, output_form::kClip);
    }
    bool works_in_space() const override { return true; }
    ExitStatus run(const EvolutionKinds& kinds) override {
        const auto path = output_path(options_.out, "", files());
        if (!path) return fail(path.error());
        Result<MovieOrder> order = movie_order(options_, *path);
        if (!order) return fail(order.error());
        order->clip.timing.seconds = seconds_;
        LongWork work;
        work.begin("simulating", static_cast<double>(kFilmScenes), "champions");
        const auto scenes = scenes_of_run(run_, kinds, work.watch());
        if (!scenes) return fail(scenes.error());
        const auto workshop = open_workshop(order->width, order->height);
        if (!workshop) return fail(workshop.error(), ExitStatus::kFailed);
        work.begin("drawing", film_length(*scenes, order->clip.timing));
        const Status made = write_film(*(*workshop)->canvas, *scenes, order->clip, work.watch());
        return made ? ExitStatus::kDone : fail(made.error(), ExitStatus::kFailed);
    }

private:
    std::string run_;
    MovieOptions options_;
    double seconds_ = 3.0;
};

}  // namespace

SubcommandKind film_subcommand() {
    return {.id = "film",
            .summary = "Make a film of a run: champions of its generations, one after the other.",
            .example = "cambrian film walking-seed1.cambrian -o film.mp4",
            .make = make_subcommand<FilmSubcommand>};
}

}  // namespace cambrian
