#pragma once

// The creature in a picture and the facts written beside it.

#include "persist/creature/creature_file.h"
#include "pictures/motion/recorded_motion.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cambrian {

struct Subject {
    JudgedIndividual creature;                // its settings are those of the recorded trial
    std::string name;                         // the creature's name, or a title
    std::string goal;                         // "Walking"
    std::string fitness;                      // with its unit; empty if it has no score
    std::optional<std::uint32_t> generation;  // generation of its birth
    RecordedTrial trial;
    TrialWorld world;   // of the recorded trial
    double mass = 0.0;  // kg
    // Whether the trial, when repeated, had the same motion as when it was scored. Empty if the
    // document does not record the motion or describes another trial.
    std::optional<bool> verified;

    double hue() const { return creature.genome().hue; }  // hue of its lineage, in turns
    const Environment& environment() const { return trial.environment; }
    const RecordedMotion& motion() const { return trial.motion; }
    const Phenotype& phenotype() const { return *trial.motion.phenotype; }
};

struct CountedMuscles {
    std::size_t number = 0;
    std::string_view noun;  // in the singular
};
// Returns the kinds of muscles that a creature has; without any, 0 moving joints.
std::vector<CountedMuscles> muscles_of(const Phenotype& phenotype);

// Runs one of the creature's trials with the settings, counted from 0. `title` is used for a
// creature without a name. Fails under the same conditions as record_trial().
Result<Subject> subject_of(const CreatureDocument& document, const ExperimentSettings& settings,
                           const std::string& title, const EvolutionKinds& kinds,
                           const TrialWatch& watch = {}, int trial = 0);

}  // namespace cambrian
