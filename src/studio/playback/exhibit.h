#pragma once

#include "creature/phenotype.h"
#include "evolution/individual/judged_individual.h"
#include "goals/goal.h"
#include "persist/text/digest_text.h"
#include "simulator/tick_checks.h"
#include "simulator/trial.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace cambrian {

// The place from which the displayed creature was taken.
enum class ExhibitSource : std::uint8_t {
    kFounder,
    kSample,
    kFile,
    kChampion,
    kPopulation,
    kHandPicked,
    kPreserve
};

// A creature on display, with the settings that evaluate it and where it was taken from.
struct Exhibit {
    JudgedIndividual creature;
    ExhibitSource source = ExhibitSource::kSample;
    std::string title;                           // "Champion of generation 12", or its file's name
    std::uint64_t experiment = 0;                // id of the experiment that bred it; 0 if none did
    std::optional<std::uint64_t> ancestry = {};  // ancestry_digest(), if its ancestors are known
    TickChecks ticks = {};  // check bytes of the motion, one per tick, if they were recorded

    const Individual& individual() const { return *creature.individual; }
    const ExperimentSettings& settings() const { return *creature.settings; }
    const GenomePtr& genome() const { return creature.individual->genome; }
    // Its name is that of its genome, of its file, or else its coined_name().
    std::string name() const;
    // The result of its evaluation; null if it was never evaluated.
    const EvaluationResult* result() const {
        return individual().evaluated ? &individual().result : nullptr;
    }
};

// The score of a creature in its world, from a trial run by the viewer.
struct ScoreReport {
    TrialRecord record;
    Score score;
    std::string unit;
    TickChecks ticks;
    std::uint64_t digest = 0;  // of the motion in all trials that the settings require
};

// Returns a creature of a generation or a picking grid as an exhibit, with a title that names its
// origin.
Exhibit exhibit_of(JudgedIndividual creature, ExhibitSource source);

}  // namespace cambrian
