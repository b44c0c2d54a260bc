#pragma once

// Layout of a directed graph in rows, with inputs above outputs.

#include <cstddef>
#include <vector>

namespace cambrian {

struct GraphEdge {
    std::size_t from = 0;
    std::size_t to = 0;
};

struct GraphPoint {
    float x = 0.0F;  // from 0 at the left to 1 at the right
    float y = 0.0F;  // from 0 at the top to 1 at the bottom
};

// Returns the row of each node: one below the lowest of its predecessors, or 0 if it has none.
// Nodes should be ordered so that most edges lead forwards; edges that lead back are ignored.
std::vector<std::size_t> graph_rows(std::size_t node_count, const std::vector<GraphEdge>& edges);

// Returns positions for nodes in given rows. Each row is spread evenly and ordered so that nodes
// are near their predecessors. Rows of more than `most` nodes are split.
std::vector<GraphPoint> place_in_rows(const std::vector<std::size_t>& rows,
                                      const std::vector<GraphEdge>& edges, std::size_t most);

}  // namespace cambrian
