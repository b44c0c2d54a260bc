#pragma once

#include "persist/creature/creature_file.h"
#include "support/kinds.h"

#include <string>

namespace cambrian::test {

// Returns a creature that uses every field of the format: two nodes, a central neuron, a score.
inline CreatureDocument sample_document() {
    const KindCatalog& catalog = kinds().creature.catalog;
    const auto function = [&](std::string_view id) {
        for (std::size_t i = 0; i < catalog.functions.size(); ++i) {
            if (catalog.functions[i].id == id) return static_cast<std::uint8_t>(i);
        }
        return std::uint8_t{0};
    };
    NodeGene body;
    body.uid = 1;
    body.edges = {EdgeGene{.target = 1, .position = 0.125, .angle = -0.4}};
    NodeGene leg;
    leg.uid = 2;
    leg.length = 0.4;
    leg.symmetric = true;
    leg.mirror_axis = MirrorAxis::kAcross;
    leg.effector = {.source = {.kind = SourceKind::kLocalNeuron}, .weight = 0.8};
    leg.neurons = {
        {.function = function("oscillate-wave"),
         .inputs = {{.source = {}, .weight = 1.1},
                    {.source = {.kind = SourceKind::kParentSensor, .index = 1}, .weight = 0.25}}}};
    CreatureDocument document;
    document.genome.nodes = {body, leg};
    document.genome.brain = {
        {.function = function("abs"),
         .inputs = {
             {.source = {.kind = SourceKind::kPartSensor, .index = 2, .node = 1, .instance = 1},
              .weight = -2.0}}}};
    document.genome.name = "two-link crawler";
    document.genome.hue = 0.31;
    document.uid = "9f3c22a1d0b4e877";
    document.parents = {"17aa040000000001", "88d1c00000000002"};
    document.method = "crossover";
    document.ancestry = 0x0123456789abcdefULL;
    ScoredRecord scored;
    scored.goal = "walking";
    scored.seed = 7;
    scored.fitness = 0.412;
    scored.unit = "BL/s";
    scored.trajectory = 0x77e0123456789abcULL;
    scored.ticks = {0x0a, 0xff, 0x00};
    scored.finer = {.outcome = Outcome::kCheated, .score = 0.4, .verdict = AuditVerdict::kSuspect};
    document.scored = scored;
    return document;
}

inline std::string sample_text() {
    return write_creature(sample_document(), kinds());
}

}  // namespace cambrian::test
