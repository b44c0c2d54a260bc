#pragma once

// One evolution of the quality benchmark (quality/README.md): its plan and its results.

#include "core/result.h"
#include "evolution/kinds/evolution_kinds.h"
#include "evolution/settings/experiment_settings.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace cambrian::quality {

struct RunSpec {
    std::string plan;  // name of the plan
    std::string goal;
    std::string arm;
    // Sample settings (*.toml) to begin with; the defaults of the goal if empty.
    std::string settings = {};
    std::uint64_t seed = 1;
    int size = 100;     // creatures per generation
    int budget = 3000;  // different evaluations after which the result is taken
    // The run lasts at least so many generations, even if the result is taken before.
    int least_generations = 0;
    int most_generations = 200;
};

struct CurvePoint {
    int evaluations = 0;
    double best = 0.0;  // best fitness so far
};

// Children of one breeding method, and how many of them were fitter than all their parents.
struct Offspring {
    int born = 0;
    int improved = 0;
};

struct RunResult : RunSpec {
    double best = 0.0;        // best fitness when the budget was used up
    double final_best = 0.0;  // best fitness at the end
    int evaluations = 0;
    int generations = 0;
    double seconds = 0.0;        // CPU time
    double invalid_share = 0.0;  // mean of all generations
    int cells = 0;               // cells of the map that creatures of the run filled
    double quality = 0.0;        // QD-score of this map
    bool decreased = false;      // the best fitness fell from one generation to the next
    // The following describe the champion of the last generation.
    double finer =
        0.0;  // fitness with a fortieth of the tolerance and a quarter of the contact step
    double late_travel = 0.0;  // distance along x in the last 30 % of the test, in body lengths
    double reversals = 0.0;    // Hz, of its joint with the highest frequency
    bool clean = false;        // whether the energy audit's verdict is clean
    std::uint64_t digest = 0;  // of all scores of the run and the champion's motion
    std::map<std::string, Offspring> offspring;  // by method id
    std::vector<CurvePoint> curve;               // one point per generation
};

// Saves the champion in the folder unless that is empty. Fails if the sample settings cannot be
// read.
Result<RunResult> perform(const RunSpec& spec, const EvolutionKinds& kinds,
                          const std::filesystem::path& champions);

}  // namespace cambrian::quality
