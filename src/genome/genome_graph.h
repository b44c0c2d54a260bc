#pragma once

// Functions on the graph of a genome's part nodes.

#include "genome/genome.h"

#include <array>
#include <cstddef>
#include <vector>

namespace cambrian {

// Returns the nodes that can be reached from a node, itself first, in breadth-first order along the
// edge lists. Edges to nodes that do not exist are skipped.
std::vector<std::size_t> breadth_first(const Genome& genome, std::size_t start);

// Keeps only the listed nodes, in the listed order, and removes edges to other nodes.
void keep_nodes(Genome& genome, const std::vector<std::size_t>& kept);

// reaches[a][b] is true if a path leads from node a to node b; a path may have no edges.
using Reachability = std::array<std::array<bool, gene_range::kMaxNodes>, gene_range::kMaxNodes>;
Reachability reachability(const Genome& genome);

}  // namespace cambrian
