#pragma once

// One evolution of the quality benchmark (quality/README.md): what it was and what it came to.

#include "evolution/kinds/evolution_kinds.h"
#include "evolution/settings/experiment_settings.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace cambrian::quality {

struct RunSpec {
    std::string plan;  // of the plan it belongs to
    std::string goal;
    std::string arm;
    std::uint64_t seed = 1;
    int size = 100;             // creatures a generation
    int budget = 3000;          // distinct evaluations after which the result is taken
    int least_generations = 0;  // goes on for so many, though the result is taken before
    int most_generations = 200;
};

struct CurvePoint {
    int evaluations = 0;
    double best = 0.0;  // fitness so far
};

// Children of one breeding method and how many of them were fitter than all their parents.
struct Offspring {
    int born = 0;
    int improved = 0;
};

struct RunResult {
    RunSpec spec;
    double best = 0.0;        // fitness, when the budget was used up
    double final_best = 0.0;  // fitness, at the end
    int evaluations = 0;
    int generations = 0;
    double seconds = 0.0;        // CPU time
    double invalid_share = 0.0;  // mean of the generations'
    int cells = 0;               // of the map that any creature of the run filled
    double quality = 0.0;        // QD-score of the same
    bool decreased = false;      // the best of a generation was below that of the one before
    // Of the last generation's champion:
    double finer = 0.0;        // fitness at a fortieth of the tolerance and half the contact step
    double late_travel = 0.0;  // body lengths along x, in the last 30 % of the test
    double reversals = 0.0;    // Hz, of its busiest joint
    bool clean = false;        // by the audit
    std::uint64_t digest = 0;  // of all scores of the run and the champion's motion
    std::map<std::string, Offspring> offspring;  // by method id
    std::vector<CurvePoint> curve;               // one point a generation
};

// The champion is saved in the folder, unless that is empty.
RunResult perform(const RunSpec& spec, const EvolutionKinds& kinds,
                  const std::filesystem::path& champions);

}  // namespace cambrian::quality
