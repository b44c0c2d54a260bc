#pragma once

// Conversion between a creature file and the displayed creature.

#include "persist/creature/creature_file.h"
#include "studio/playback/exhibit.h"

#include <filesystem>

namespace cambrian {

// Returns the creature of a file that was read from `path`. A creature without a score gets the
// settings `otherwise`.
Exhibit exhibit_of(const CreatureDocument& document, const ExperimentSettings& otherwise,
                   ExhibitSource source, const std::filesystem::path& path);

// Returns the creature file of an exhibit. `score` is the score of the displayed trial or null; it
// is used if the creature was never evaluated.
CreatureDocument document_of(const Exhibit& exhibit, const ScoreReport* score,
                             const EvolutionKinds& kinds);

}  // namespace cambrian
