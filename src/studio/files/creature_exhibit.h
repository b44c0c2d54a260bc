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

// What a file of the exhibit holds. `score` is that of the trial on display, or null; it replaces
// for a result the creature does not have.
CreatureDocument document_of(const Exhibit& exhibit, const ScoreReport* score,
                             const EvolutionKinds& kinds);

}  // namespace cambrian
