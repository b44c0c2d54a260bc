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
    Genome genome;
    genome.nodes = {body, leg};
    genome.brain = {
        {.function = function("abs"),
         .inputs = {
             {.source = {.kind = SourceKind::kPartSensor, .index = 2, .node = 1, .instance = 1},
              .weight = -2.0}}}};
    genome.name = "two-link crawler";
    genome.hue = 0.31;
    CreatureDocument document{unjudged(std::make_shared<const Genome>(genome))};
    document.ancestry = 0x0123456789abcdefULL;
    document.notes.unit = "BL/s";
    document.notes.ticks = {0x0a, 0xff, 0x00};
    change_settings(document.creature, [](ExperimentSettings& settings) { settings.seed = 7; });
    change_individual(document.creature, [](Individual& individual) {
        individual.uid = 0x9f3c22a1d0b4e877ULL;
        individual.parents = {0x17aa040000000001ULL, 0x88d1c00000000002ULL};
        individual.method = "crossover";
        individual.evaluated = true;
        individual.result.fitness = 0.412;
        individual.result.digest = 0x77e0123456789abcULL;
        individual.result.finer = {
            .outcome = Outcome::kDisqualified, .score = 0.4, .verdict = AuditVerdict::kSuspect};
    });
    return document;
}

// The document with its genome edited.
template <class Change>
CreatureDocument with_genome(CreatureDocument document, Change change) {
    change_individual(document.creature, [&](Individual& individual) {
        Genome genome = *individual.genome;
        change(genome);
        individual.genome = std::make_shared<const Genome>(std::move(genome));
    });
    return document;
}

// Gives the leg a voice that hears its neuron and a scent gland that hears the joint of a child.
inline CreatureDocument with_organs(CreatureDocument document) {
    return with_genome(std::move(document), [](Genome& genome) {
        const SourceRef child{SourceKind::kChildSensor, 0, 3};
        genome.nodes[1].organs = {
            {.kind = 0, .input = {{SourceKind::kLocalNeuron}, 2.0}, .parameters = {2.0}},
            {.kind = 1, .input = {child, -0.5}}};
    });
}

inline void drop_score(CreatureDocument& document) {
    document.creature.individual = without_score(*document.creature.individual);
}

inline std::string sample_text() {
    return write_creature(sample_document(), kinds());
}

}  // namespace cambrian::test
