#pragma once

// Carries out "Run 10 generations from these picks": evolves a small population of the picks and
// their mutants under the present goal. The next grid is chosen from its best (picking/README.md
// 1).

#include "evolution/evolution.h"

#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

namespace cambrian {

inline constexpr int kAssistedPopulation = 60;
inline constexpr int kMostAssistedGenerations = 1000;

class Assistance {
public:
    // Needs at least one pick, generations from 1 to kMostAssistedGenerations, and settings that
    // pass check_settings(). `node` is the number of the grid to be made.
    Assistance(std::span<const IndividualPtr> picks, int generations, std::uint32_t node,
               const ExperimentSettings& settings, const EvolutionKinds& kinds);

    // Evaluates one generation: the founders at first, then offspring of the last generation.
    // Returns false if it was stopped; it may then be called again to continue.
    bool step(EvaluationBackend& backend, EvaluationProgress& progress,
              const std::stop_token& stop);
    int generations() const { return generations_; }  // number requested
    int generations_done() const { return done_; }    // number bred and evaluated
    bool done() const { return evolution_.evaluated() && done_ == generations_; }

    // Returns the better half of the last generation, best first; may be called when done.
    // Creatures whose score depends on the seed have no score, since the experiment has another
    // seed.
    std::vector<IndividualPtr> elites() const;

private:
    int generations_;
    int done_ = 0;
    Evolution evolution_;
};

}  // namespace cambrian
