#pragma once

// One evolution of a comparison: what it was, and what it came to after so many trials.

#include "evolution/evaluation/evaluation_backend.h"
#include "evolution/individual/individual.h"
#include "evolution/kinds/evolution_kinds.h"
#include "evolution/settings/experiment_settings.h"

#include <atomic>
#include <cstdint>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace cambrian {

struct CurvePoint {
    int trials = 0;      // since the beginning
    double score = 0.0;  // of the best creature

    friend bool operator==(const CurvePoint&, const CurvePoint&) = default;
};

struct PlannedRun {
    std::string world;     // name of what the arms are compared in
    std::string arm;       // name of what is compared
    SettingsPtr settings;  // with the run's seed
    int trials = 0;        // distinct ones, after which the result is taken
};

// A row of the table of runs. Scores are in the goal's unit.
struct ComparedRun {
    std::string world;
    std::string arm;
    std::uint64_t seed = 0;
    int trials = 0;            // as planned
    std::string settings;      // digest of all of them
    std::string simulator;     // its version
    double score = 0.0;        // of the champion, as its settings judge it
    double confirmed = 0.0;    // median of the champion's scores in ten slightly different worlds
    double finer = 0.0;        // of the champion, with fine steps of an accurate integrator
    double jump_height = 0.0;  // m, v^2 / (2 g) of the champion's speed at the take-off of its best
    int parts = 0;             // of the champion
    int lines = 0;             // founders that the survivors of the last generation descend from
    int plans = 0;             // body plans among its best 20 survivors
    int generations = 0;
    int evaluations = 0;            // trials run
    int audited = 0;                // trials found hopeless and finished all the same
    int survivors = 0;              // of those, that would have survived
    double time_saved = 0.0;        // share of the simulated time, mean of all generations
    double seconds = 0.0;           // of one core, besides what was evaluated elsewhere
    std::vector<CurvePoint> curve;  // a point a generation

    friend bool operator==(const ComparedRun&, const ComparedRun&) = default;
};

struct FinishedRun {
    ComparedRun row;
    IndividualPtr champion;
};

// The run's row as far as it is known beforehand; a finished one of the same need not be run again.
ComparedRun planned_row(const PlannedRun& run, const EvolutionKinds& kinds);
bool is_row_of(const ComparedRun& finished, const ComparedRun& planned);

// Evolves until so many trials are run. None if stopped, or if the back-end cannot go on. `done`
// grows by every trial.
std::optional<FinishedRun> perform(const PlannedRun& run, const EvolutionKinds& kinds,
                                   EvaluationBackend& backend, std::atomic<std::uint64_t>& done,
                                   const std::stop_token& stop);

}  // namespace cambrian
