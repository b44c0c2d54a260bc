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

// Where a displayed creature comes from.
enum class ExhibitSource : std::uint8_t { kSample, kFile, kChampion, kPopulation, kHandPicked };

// A creature on display: the creature with the settings that judge it, and where it was taken from.
struct Exhibit {
    JudgedIndividual creature;
    ExhibitSource source = ExhibitSource::kSample;
    std::string title;                           // "Champion of generation 12"
    std::uint64_t experiment = 0;                // of the engine that bred it; 0 if none did
    std::optional<std::uint64_t> ancestry = {};  // ancestry_digest(), if its line is known
    TickChecks ticks = {};                       // of the motion, if they were noted

    const Individual& individual() const { return *creature.individual; }
    const ExperimentSettings& settings() const { return *creature.settings; }
    const GenomePtr& genome() const { return creature.individual->genome; }
    // As evaluated; null if the creature never was.
    const EvaluationResult* result() const {
        return individual().evaluated ? &individual().result : nullptr;
    }
};

// How a creature scores in its world, from a trial of its own.
struct ScoreReport {
    TrialRecord record;
    Score score;
    std::string unit;
    TickChecks ticks;
    std::uint64_t digest = 0;  // of the motion in all trials its world asks for
};

// A creature of a generation or of a grid, with a title that says which.
Exhibit exhibit_of(JudgedIndividual creature, ExhibitSource source);

}  // namespace cambrian
