#pragma once

// "Run 10 generations from these picks": automatic evolution of a small population of the picks and
// their mutants under the current goal, to choose the next grid from (picking/README.md 1).

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
    // At least one pick; generations from 1 to kMostAssistedGenerations; settings must pass
    // check_settings. node: number of the grid it is for.
    Assistance(std::span<const IndividualPtr> picks, int generations, std::uint32_t node,
               const ExperimentSettings& settings, const EvolutionKinds& kinds);

    // Evaluates a generation: at first that of the founders, then one bred from the last. False if
    // stopped; the call may be repeated to go on.
    bool step(EvaluationBackend& backend, EvaluationProgress& progress,
              const std::stop_token& stop);
    int generations() const { return generations_; }  // asked for
    int generations_done() const { return done_; }    // bred and evaluated
    bool done() const { return evolution_.evaluated() && done_ == generations_; }

    // The better half of the last generation, best first; once done. Without their scores where
    // these depend on the seed, which was another than the experiment's.
    std::vector<IndividualPtr> elites() const;

private:
    int generations_;
    int done_ = 0;
    Evolution evolution_;
};

}  // namespace cambrian
