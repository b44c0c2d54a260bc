#pragma once

// The lesion lab: a creature is deprived of each part, joint, neuron, link, sensor and organ in
// turn, and its score that is left is measured in several slightly different worlds.

#include "creature/lesion.h"
#include "evolution/evaluation/evaluation_backend.h"

#include <cstddef>
#include <optional>
#include <stop_token>
#include <vector>

namespace cambrian {

inline constexpr int kLesionWorlds = 11;
inline constexpr std::size_t kPairedLesions = 10;  // the worst ones, which pairs are made of

struct LesionRow {
    std::vector<Lesion> lesions;  // one, or the two of a pair
    std::vector<double> scores;   // in each world
    double left = 0.0;            // their median
};

struct LesionTable {
    LesionRow intact;
    std::vector<LesionRow> rows;   // what costs most first
    std::vector<LesionRow> pairs;  // the same
};

// The creature whose lesions are studied, and how.
struct LesionStudy {
    GenomePtr genome;
    const ExperimentSettings& settings;
    int worlds = kLesionWorlds;
    bool pairs = false;  // whether the worst lesions are also inflicted two at a time
};

// A silenced sensor is followed by the same with its best constant, if that leaves more. Returns
// nothing after a stop request.
std::optional<LesionTable> lesion_table(const LesionStudy& study, const EvolutionKinds& kinds,
                                        EvaluationBackend& backend, EvaluationProgress& progress,
                                        const std::stop_token& stop = {});

// The worlds of lesions and pruning.
std::vector<Probe> lesion_probes(const ExperimentSettings& settings, int worlds);

}  // namespace cambrian
