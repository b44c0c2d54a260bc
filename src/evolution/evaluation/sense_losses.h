#pragma once

// What a creature loses without its senses: each wired sensor reads its best constant instead. A
// creature that does as well with constants does not use what it senses.

#include "evolution/evaluation/evaluation.h"

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

namespace cambrian {

// The constants that one sensor is tried with, in its unit: 0, then from the least to the greatest
// that it reads.
using SenseConstants = std::array<double, 6>;

// Returns those of each wired sensor, from its readings in two trials.
std::vector<SenseConstants> sense_constants(const std::shared_ptr<const Phenotype>& body,
                                            const ExperimentSettings& settings,
                                            const EvolutionKinds& kinds,
                                            const std::stop_token& stop = {});

struct SenseLoss {
    std::string channel;    // "obstacle-left"
    std::size_t part = 0;   // number of the part that has it, from 0
    double constant = 0.0;  // that leaves most, in the sensor's unit
    double score = 0.0;     // that is left with it
};

struct SenseLosses {
    double intact = 0.0;          // score in trials that no generation uses
    double without_all = 0.0;     // the same with a constant for each sensor
    std::vector<SenseLoss> each;  // each sensor that the brain hears, alone
};

// Constants are chosen in the same trials, which favours them: five sets for all sensors together
// (0, least, greatest, mean and middle readings), then six for each. After a stop request the rest
// is missing. `note` is told the share that is done, on the same thread.
SenseLosses sense_losses(const GenomePtr& genome, const ExperimentSettings& settings,
                         const EvolutionKinds& kinds, const std::stop_token& stop = {},
                         const std::function<void(double)>& note = {});

// A creature that keeps a larger share of its score with constants does not need its senses.
inline constexpr double kNeededShare = 0.9;
// Returns whether a creature needs its senses; the same search, which ends when that is known.
bool needs_senses(const GenomePtr& genome, const ExperimentSettings& settings,
                  const EvolutionKinds& kinds, const std::stop_token& stop = {});

}  // namespace cambrian
