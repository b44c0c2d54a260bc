#pragma once

// Places nodes of a directed graph in rows, inputs above outputs.

#include <cstddef>
#include <vector>

namespace cambrian {

struct GraphEdge {
    std::size_t from = 0;
    std::size_t to = 0;
};

struct GraphPoint {
    float x = 0.0F;  // 0 left to 1 right
    float y = 0.0F;  // 0 top to 1 bottom
};

// The row of each node: 0 for those nothing earlier leads to, otherwise one below the lowest node
// that leads to it. Nodes must be given so that edges mostly lead forwards; edges that lead back
// are ignored.
std::vector<std::size_t> graph_rows(std::size_t node_count, const std::vector<GraphEdge>& edges);

// Points for nodes in given rows, each row spread evenly and ordered so that nodes stand near what
// leads to them. Rows of more than `most` nodes are broken into several.
std::vector<GraphPoint> place_in_rows(const std::vector<std::size_t>& rows,
                                      const std::vector<GraphEdge>& edges, std::size_t most);

}  // namespace cambrian
