#pragma once

// A film of a run: several creatures one after the other in the same world.

#include "pictures/clip.h"

#include <vector>

namespace cambrian {

inline constexpr std::size_t kFilmScenes = 12;  // most in a film of a run

// Returns champions spread over the generations of an experiment, the first one first, each in the
// world of the last one and named after its generation. Fails if it is stopped.
Result<std::vector<Subject>> scenes_of_run(const std::filesystem::path& run,
                                           const EvolutionKinds& kinds,
                                           const TrialWatch& watch = {});

// Writes the beginning of each trial, `order.timing.seconds` of it at most. `scenes` must not be
// empty; their names are the captions. Notes the seconds of the film that are written, and gives up
// when asked to stop; nothing is left then.
Status write_film(PictureCanvas& canvas, const std::vector<Subject>& scenes, const ClipOrder& order,
                  const TrialWatch& watch);

// Returns the duration of the film, in s.
double film_length(const std::vector<Subject>& scenes, const ClipTiming& timing);

}  // namespace cambrian
