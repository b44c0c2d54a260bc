#pragma once

// What a creature loses by lesions, as text.

#include "evolution/evaluation/lesion_table.h"
#include "evolution/evaluation/pruning.h"

#include <optional>
#include <string>

namespace cambrian {

struct LesionReport {
    const LesionTable& table;
    const Phenotype& intact;
    const Kinds& kinds;
    std::string unit;  // of the scores
};

// A line for the intact creature, then one for each lesion, what costs most first.
std::string lesions_text(const LesionReport& report);
std::string lesions_csv(const LesionReport& report);
// `pruned` may be null.
std::string lesions_json(const LesionReport& report, const PrunedCreature* pruned);

// Example: "without 12 genes that cost nothing: 0.93 of 0.92 BL/s".
std::string pruning_text(const PrunedCreature& pruned, const std::string& unit);

}  // namespace cambrian
