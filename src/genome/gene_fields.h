#pragma once

// The only table of the genes' scalar fields, with range, mutation step and distribution in
// founders. Validation, repair, random genomes and mutation use it and name no field. Genes in
// space have more fields than those of the plane, which come first.

#include "genome/field_rule.h"
#include "genome/genome.h"

#include <span>

namespace cambrian {

inline MirrorAxis last_mirror_axis(int dimensions) {
    return dimensions == 3 ? MirrorAxis::kDepth : MirrorAxis::kAcross;
}

template <class Gene>
struct GeneField {
    FieldRule rule;
    double Gene::*value;
};

std::span<const GeneField<NodeGene>> node_fields(int dimensions);
std::span<const GeneField<EdgeGene>> edge_fields(int dimensions);
std::span<const GeneField<InputGene>> input_fields();              // the weight
std::span<const GeneField<Genome>> genome_fields(int dimensions);  // the root's angles
std::span<const GeneField<DegreeGene>> degree_fields();            // of space only

}  // namespace cambrian
