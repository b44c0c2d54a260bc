#pragma once

// The outer graph of a genome: which nodes can be reached, in which order, from where.

#include "genome/genome.h"

#include <array>
#include <cstddef>
#include <vector>

namespace cambrian {

// Indices of the nodes reachable from a node, itself first, breadth-first following edge-list
// order. Edges to nodes that do not exist are skipped.
std::vector<std::size_t> breadth_first(const Genome& genome, std::size_t start);

// Leaves only the listed nodes, in the listed order, and drops edges to others.
void keep_nodes(Genome& genome, const std::vector<std::size_t>& kept);

// reaches[a][b]: whether a path of any number of edges, none included, leads from node a to b.
using Reachability = std::array<std::array<bool, gene_range::kMaxNodes>, gene_range::kMaxNodes>;
Reachability reachability(const Genome& genome);

}  // namespace cambrian
