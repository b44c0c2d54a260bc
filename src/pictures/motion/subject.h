#pragma once

// Whom a picture shows and what is written beside it.

#include "persist/creature/creature_file.h"
#include "pictures/motion/recorded_motion.h"

#include <cstdint>
#include <optional>
#include <string>

namespace cambrian {

struct Subject {
    JudgedIndividual creature;                // with the settings of the trial shown
    std::string name;                         // its own, or the title
    std::string goal;                         // "Walking"
    std::string fitness;                      // with its unit; empty without one
    std::optional<std::uint32_t> generation;  // it was born in
    RecordedTrial trial;
    double mass = 0.0;  // kg
    // Whether the trial, run again, moved as it did when it scored the creature; only if the
    // document tells and this is the trial it tells of.
    std::optional<bool> verified;

    double hue() const { return creature.genome().hue; }  // of its lineage, in turns
    const Environment& environment() const { return creature.settings->world.environment; }
    const RecordedMotion& motion() const { return trial.motion; }
    const Phenotype& phenotype() const { return *trial.motion.phenotype; }
};

// Runs the creature's trial under the settings; `title` names one without a name. Fails as
// record_trial() does.
Result<Subject> subject_of(const CreatureDocument& document, const ExperimentSettings& settings,
                           const std::string& title, const EvolutionKinds& kinds,
                           const TrialWatch& watch = {});

}  // namespace cambrian
