#pragma once

// Pruning: a creature without the genes that cost it nothing.

#include "evolution/evaluation/evaluation_backend.h"
#include "evolution/evaluation/lesion_table.h"

#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace cambrian {

struct PrunedCreature {
    GenomePtr genome;
    std::vector<std::string> removed;  // genes, in the words of gene_sites.h, in order
    double before = 0.0;               // median score in the worlds of the study
    double after = 0.0;
};

// Removes attachments, organs and links one at a time, as long as the median score stays at least
// 99.7 % of that of the whole creature, until none can be removed, and then the neurons that
// nothing hears. Returns nothing after a stop request; `progress` is that of the present pass.
std::optional<PrunedCreature> pruned(const LesionStudy& study, const EvolutionKinds& kinds,
                                     EvaluationBackend& backend, EvaluationProgress& progress,
                                     const std::stop_token& stop = {});

}  // namespace cambrian
