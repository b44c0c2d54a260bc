#pragma once

// Between a creature's file and the creature on display.

#include "persist/creature/creature_file.h"
#include "studio/playback/exhibit.h"

#include <filesystem>

namespace cambrian {

// The creature of a file that was read from `path`. One that was never scored is judged by
// `otherwise`.
Exhibit exhibit_of(const CreatureDocument& document, const ExperimentSettings& otherwise,
                   ExhibitSource source, const std::filesystem::path& path);

// The creature file of an exhibit. `score` is that of the displayed trial, or null; it is used if
// the creature has no result.
CreatureDocument document_of(const Exhibit& exhibit, const ScoreReport* score,
                             const EvolutionKinds& kinds);

}  // namespace cambrian
