#include "genome/genome_graph.h"

#include "core/assert.h"

#include <optional>
#include <utility>

namespace cambrian {

std::vector<std::size_t> breadth_first(const Genome& genome, std::size_t start) {
    CAMBRIAN_ASSERT(start < genome.nodes.size(), "a search starts at a node");
    std::vector<bool> seen(genome.nodes.size(), false);
    std::vector<std::size_t> order = {start};
    seen[start] = true;
    for (std::size_t next = 0; next < order.size(); ++next) {
        for (const EdgeGene& edge : genome.nodes[order[next]].edges) {
            if (edge.target >= genome.nodes.size() || seen[edge.target]) continue;
            seen[edge.target] = true;
            order.push_back(edge.target);
        }
    }
    CAMBRIAN_TICK_ASSERT(order.size() <= genome.nodes.size(), "a node is reached once");
    return order;
}

void keep_nodes(Genome& genome, const std::vector<std::size_t>& kept) {
    std::vector<std::optional<std::uint8_t>> new_index(genome.nodes.size());
    for (std::size_t i = 0; i < kept.size(); ++i)
        new_index[kept[i]] = static_cast<std::uint8_t>(i);
    std::vector<NodeGene> nodes;
    nodes.reserve(kept.size());
    for (const std::size_t old : kept) {
        CAMBRIAN_TICK_ASSERT(old < genome.nodes.size(), "a node of the genome");
        NodeGene node = std::move(genome.nodes[old]);
        std::erase_if(node.edges, [&](const EdgeGene& edge) { return !new_index[edge.target]; });
        for (EdgeGene& edge : node.edges)
            edge.target = *new_index[edge.target];
        nodes.push_back(std::move(node));
    }
    genome.nodes = std::move(nodes);
}

Reachability reachability(const Genome& genome) {
    CAMBRIAN_TICK_ASSERT(genome.nodes.size() <= gene_range::kMaxNodes, "nodes have room");
    Reachability reaches{};
    for (std::size_t start = 0; start < genome.nodes.size(); ++start) {
        for (const std::size_t node : breadth_first(genome, start))
            reaches[start][node] = true;
    }
    return reaches;
}

}  // namespace cambrian
