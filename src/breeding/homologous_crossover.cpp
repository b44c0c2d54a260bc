// Homologous crossover (breeding/README.md 7, option): the second parent's nodes are first put into
// the order of the first's, by equal uid or else by position.

#include "breeding/methods.h"
#include "core/assert.h"

#include <algorithm>
#include <optional>

namespace cambrian {
namespace {

// Returns the old indices of the second parent's nodes in their new order. The root stays first.
std::vector<std::size_t> aligned_order(const Genome& first, const Genome& second) {
    std::vector<std::size_t> waiting;
    for (std::size_t i = 1; i < second.nodes.size(); ++i)
        waiting.push_back(i);
    const auto has_uid = [&](std::uint32_t uid) {
        return [&second, uid](std::size_t i) { return second.nodes[i].uid == uid; };
    };
    const auto is_matched = [&](std::size_t i) {
        return std::any_of(first.nodes.begin() + 1, first.nodes.end(),
                           [&](const NodeGene& node) { return node.uid == second.nodes[i].uid; });
    };
    std::vector<std::size_t> order = {0};
    for (std::size_t i = 1; i < first.nodes.size() && !waiting.empty(); ++i) {
        auto next = std::find_if(waiting.begin(), waiting.end(), has_uid(first.nodes[i].uid));
        if (next == waiting.end())
            next = std::find_if_not(waiting.begin(), waiting.end(), is_matched);
        if (next == waiting.end()) continue;
        order.push_back(*next);
        waiting.erase(next);
    }
    order.insert(order.end(), waiting.begin(), waiting.end());
    return order;
}

Genome reordered(const Genome& genome, const std::vector<std::size_t>& order) {
    std::vector<std::uint8_t> place(order.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        place[order[i]] = static_cast<std::uint8_t>(i);
    CAMBRIAN_TICK_ASSERT(order.size() == genome.nodes.size(), "every node has a place");
    CAMBRIAN_TICK_ASSERT(order.front() == 0, "the root stays the root");
    Genome result = genome;
    for (std::size_t i = 0; i < order.size(); ++i) {
        result.nodes[i] = genome.nodes[order[i]];
        for (EdgeGene& edge : result.nodes[i].edges)
            edge.target = place[edge.target];
    }
    return result;
}

Genome breed_homologous(const Genome& first, const Genome& second, const KindCatalog& catalog,
                        RandomStream& stream) {
    return cross(first, reordered(second, aligned_order(first, second)), catalog, stream);
}

}  // namespace

void add_homologous_crossover(BreedingRegistry& methods) {
    methods.add({.id = "homologous-crossover",
                 .label = "Homologous crossover",
                 .parents = 2,
                 .default_share = 0.0,
                 .heritable = false,
                 .breed = breed_homologous});
}

}  // namespace cambrian
