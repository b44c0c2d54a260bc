#pragma once

// The only table of the genes' scalar fields, with range, mutation step and distribution in
// founders. Validation, repair, random genomes and mutation use it and name no field. Three
// dimensions would need only a few more rows.

#include "genome/field_rule.h"
#include "genome/genome.h"

#include <span>

namespace cambrian {

template <class Gene>
struct GeneField {
    FieldRule rule;
    double Gene::*value;
};

std::span<const GeneField<NodeGene>> node_fields();
std::span<const GeneField<EdgeGene>> edge_fields();
std::span<const GeneField<InputGene>> input_fields();  // the weight
std::span<const GeneField<Genome>> genome_fields();    // the root's angle

}  // namespace cambrian
