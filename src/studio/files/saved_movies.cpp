#include "studio/files/saved_movies.h"

#include "genome/creature_name.h"
#include "pictures/film.h"
#include "pictures/race.h"
#include "pictures/workshop.h"

#include <algorithm>
#include <utility>

namespace cambrian {
namespace {

ClipOrder movie_clip_order(const std::filesystem::path& path, const ClipChoice& choice,
                           const Palette& palette) {
    return {.format = choice.format,
            .path = path,
            .timing = {.frames_a_second = choice.format->usual_rate,
                       .speed = choice.speed,
                       .seconds = choice.seconds},
            .palette = palette};
}

}  // namespace

Status write_run_film(const RunFilm& film, const EvolutionKinds& kinds, const TrialWatch& watch) {
    const std::filesystem::path run = film.run->path();
    if (run.empty()) return Error{"this run has no file yet; save the experiment (Ctrl+K)"};
    const auto scenes = scenes_of_run(run, kinds, {.stop = watch.stop});
    if (!scenes) return scenes.error();
    const auto workshop = open_workshop(film.choice.width, film.choice.height);
    if (!workshop) return workshop.error();
    return write_film(*(*workshop)->canvas, *scenes,
                      movie_clip_order(film.path, film.choice, film.palette), watch);
}

Status write_creature_race(const CreatureRace& race, const EvolutionKinds& kinds,
                           const TrialWatch& watch) {
    std::vector<Subject> runners;
    for (const JudgedIndividual& creature : race.creatures) {
        auto runner = subject_of(creature_document(creature, kinds), race.settings,
                                 creature_name(creature.genome()), kinds, {.stop = watch.stop});
        if (!runner) return runner.error();
        runners.push_back(*std::move(runner));
    }
    const Race drawn(std::move(runners));
    const auto workshop = open_workshop(race.choice.width, race.choice.height);
    if (!workshop) return workshop.error();
    ClipOrder order = movie_clip_order(race.path, race.choice, race.palette);
    order.timing.seconds = std::min(order.timing.seconds, drawn.length());
    return write_race(*(*workshop)->canvas, drawn, order, watch);
}

}  // namespace cambrian
