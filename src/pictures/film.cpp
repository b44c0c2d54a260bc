#include "pictures/film.h"

#include "persist/experiment/experiment_parts.h"

#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace cambrian {
namespace {

ClipTiming timing_of_scene(const Subject& scene, ClipTiming timing) {
    timing.seconds = std::min(timing.seconds, scene.motion().length());
    return timing;
}

std::uint64_t film_frames(const std::vector<Subject>& scenes, const ClipTiming& timing) {
    std::uint64_t frames = 0;
    for (const Subject& scene : scenes)
        frames += clip_frames(timing_of_scene(scene, timing));
    return frames;
}

}  // namespace

Result<std::vector<Subject>> scenes_of_run(const std::filesystem::path& run,
                                           const EvolutionKinds& kinds, const TrialWatch& watch) {
    const auto last = load_champion(run, std::nullopt, kinds);
    if (!last) return last.error();
    std::vector<Subject> scenes;
    for (const std::uint32_t generation :
         spread_generations(last->creature.generation, kFilmScenes)) {
        const auto kept = load_champion(run, generation, kinds);
        if (!kept) return kept.error();
        auto scene = subject_of(creature_document(kept->creature, kinds), *last->creature.settings,
                                {}, kinds, {.stop = watch.stop});
        if (watch.stop.stop_requested()) return Error{"interrupted; nothing was written"};
        if (!scene) return scene.error();
        scene->name = fmt::format("Generation {}", generation);
        scenes.push_back(*std::move(scene));
        watch.note(static_cast<double>(scenes.size()));
    }
    return scenes;
}

double film_length(const std::vector<Subject>& scenes, const ClipTiming& timing) {
    return static_cast<double>(film_frames(scenes, timing)) / timing.frames_a_second;
}

Status write_film(PictureCanvas& canvas, const std::vector<Subject>& scenes, const ClipOrder& order,
                  const TrialWatch& watch) {
    const auto draw = [&](std::uint64_t frame) {
        auto scene = scenes.begin();
        for (std::uint64_t length = 0;
             (length = clip_frames(timing_of_scene(*scene, order.timing))) <= frame; ++scene)
            frame -= length;
        draw_clip_frame(canvas, *scene, order.palette,
                        moment_of(scene->motion(), clip_time(order.timing, frame)));
    };
    return write_pictures(canvas, order, film_frames(scenes, order.timing), draw, draw, watch);
}

}  // namespace cambrian
