#pragma once

// The genotype: a directed graph of part nodes, each with its own neurons, and a central brain
// (genome/README.md 1). It has value semantics; it is immutable once an individual has it
// (GenomePtr).

#include "genome/gene.h"
#include "genome/kind_catalog.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace cambrian {

struct Genome {
    std::vector<NodeGene> nodes;               // 1 to 16; nodes[0] is the root
    std::vector<NeuronGene> brain;             // central neurons, 0 to 16
    double root_angle = 0.0;                   // rad, [-pi, pi)
    double root_tilt = 0.0;                    // rad, [-pi/2, pi/2]; of space only
    double root_roll = 0.0;                    // rad, [-pi, pi); of space only
    int dimensions = 2;                        // of the space its body lives in: 2 or 3
    std::uint8_t reproduction = kNoOwnMethod;  // index into KindCatalog::reproductions
    // The following fields are not expressed.
    double hue = 0.0;  // [0, 1), display colour
    std::string name;  // at most 64 bytes

    // Compares all that is expressed: everything but hue, name and the nodes' uids.
    friend bool operator==(const Genome& a, const Genome& b);
};

using GenomePtr = std::shared_ptr<const Genome>;

// Returns the FNV-1a hash of the canonical binary form of all fields that affect phenotype or
// breeding.
std::uint64_t genome_hash(const Genome& genome);

// Returns the number of genes of parts, edges and root in which two bodies differ; an edge is one
// gene, and a part that only one of them has counts as all its genes. Neurons, effectors and organs
// may differ.
int differing_body_genes(const Genome& a, const Genome& b);

// Returns all faults, one sentence each, with places like JSON pointers; empty if valid
// (genome/README.md 3).
std::vector<std::string> validate(const Genome& genome, const KindCatalog& catalog);

// Returns a genome of space that grows into the same body as a planar one, as deep as its parts are
// wide. A depth of 0 or less means the width of each part. The joints of both must have the same
// order as far as those of the plane go.
Genome lifted(const Genome& planar, double depth);

// Makes any genome valid by the steps of genome/README.md 3. It is idempotent; every operator ends
// with it.
void repair(Genome& genome, const KindCatalog& catalog);

}  // namespace cambrian
