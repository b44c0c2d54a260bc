#pragma once

#include "creature/phenotype.h"
#include "evolution/experiment_settings.h"
#include "evolution/individual.h"
#include "evolution/judged_settings.h"
#include "goals/goal.h"
#include "simulator/tick_checks.h"
#include "simulator/trial.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace cambrian {

// Where a creature on show comes from.
enum class ExhibitSource : std::uint8_t { kSample, kFile, kChampion, kPopulation, kHandPicked };

// A creature on show, in the world it is judged in.
struct Exhibit {
    GenomePtr genome;
    TrialWorld world;
    std::string goal;  // id
    ExpressionSettings expression;
    ExhibitSource source = ExhibitSource::kSample;
    std::string title;  // "Champion of generation 12"
    std::uint64_t seed = 0;
    std::uint32_t generation = 0;
    std::uint64_t experiment = 0;  // of the engine that bred it; 0 if none did
    std::uint32_t born = 0;        // generation
    std::string uid;               // as files name it
    std::string method;
    std::vector<std::string> parents;
    ParentLink mother;
    std::vector<MutationRecord> mutations;
    std::optional<std::uint64_t> ancestry;   // ancestry_digest(), if its line is known
    std::optional<EvaluationResult> result;  // as evaluated, if it was
    TickChecks ticks;                        // of the motion, if they were noted
};

// How a creature scores in its world, from a trial of its own.
struct ScoreReport {
    TrialRecord record;
    Score score;
    std::string unit;
    TickChecks ticks;
    std::uint64_t digest = 0;  // of the motion in all trials its world asks for
};

// A uid as sixteen hexadecimal digits; empty for 0.
std::string uid_text(std::uint64_t uid);
// The number such digits stand for; 0 for any other text.
std::uint64_t uid_of(const std::string& text);

// In which a goal (by its id) measures fitness; empty if it is not known.
std::string goal_unit(const std::string& goal, const GoalRegistry& goals);

Exhibit exhibit_of(const Individual& individual, const ExperimentSettings& settings,
                   std::uint32_t generation, ExhibitSource source);
// The creature on show as an individual, a parent for others.
IndividualPtr individual_of(const Exhibit& exhibit);

}  // namespace cambrian
