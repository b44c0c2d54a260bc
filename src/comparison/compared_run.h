#pragma once

// One run of a comparison: its plan, its result and the course of its best score.

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
    int trials = 0;      // trials run since the start
    double score = 0.0;  // score of the best creature so far

    friend bool operator==(const CurvePoint&, const CurvePoint&) = default;
};

struct PlannedRun {
    std::string world;                     // name of the world
    std::string arm;                       // name of the arm
    SettingsPtr settings;                  // settings with the run's seed
    int trials = 0;                        // number of different trials after which the run ends
    std::vector<GenomePtr> founders = {};  // from a museum; random creatures take the other places
};

// A row of the table of runs. Scores are in the goal's unit.
struct ComparedRun {
    std::string world;
    std::string arm;
    std::uint64_t seed = 0;
    int trials = 0;          // planned number of trials
    std::string settings;    // digest of all settings
    std::string simulator;   // version of the simulator
    double score = 0.0;      // score of the champion by the run's own settings
    double confirmed = 0.0;  // median of the champion's scores in ten slightly different worlds
    double finer = 0.0;      // score of the champion with an accurate integrator and fine steps
    // v^2 / (2 g) in m, for the take-off speed v of the champion's best jump.
    double jump_height = 0.0;
    int parts = 0;         // parts of the champion
    int needs_senses = 0;  // 1 if the champion needs its senses (needs_senses()), 0 if not
    int lines = 0;         // founders from whom the survivors of the last generation descend
    int plans = 0;         // different body plans among the best 20 survivors
    int generations = 0;
    int evaluations = 0;  // trials run
    int audited = 0;      // trials that were run to their end although early termination applied
    int survivors = 0;    // creatures among these that would have survived
    // Share of simulated time saved by early termination, mean over all generations.
    double time_saved = 0.0;
    double seconds = 0.0;           // computing time of one core of this machine
    std::vector<CurvePoint> curve;  // one point per generation

    friend bool operator==(const ComparedRun&, const ComparedRun&) = default;
};

struct FinishedRun {
    ComparedRun row;
    IndividualPtr champion;
    SettingsPtr settings;  // by which the champion was scored, with the opponents that were drawn
};

// Returns the row of a run with the values that are known in advance. is_row_of() tells whether a
// finished row has the same plan, so that the run need not be repeated.
ComparedRun planned_row(const PlannedRun& run, const EvolutionKinds& kinds);
bool is_row_of(const ComparedRun& finished, const ComparedRun& planned);

// Evolves until the planned number of trials has been run. Returns nothing if it was stopped or if
// the back-end cannot continue. `done` grows by its trials after every generation.
std::optional<FinishedRun> perform(const PlannedRun& run, const EvolutionKinds& kinds,
                                   EvaluationBackend& backend, std::atomic<std::uint64_t>& done,
                                   const std::stop_token& stop);

}  // namespace cambrian
