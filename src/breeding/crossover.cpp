// Crossover (breeding/README.md 7): the parents' nodes are aligned by canonical order and copied
// from one parent until a switch point, then from the other. Edges keep the index they point to.

#include "breeding/methods.h"
#include "core/assert.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace cambrian {
namespace {

// Probabilities of 1, 2 and 3 switch points.
constexpr std::array<double, 3> kSwitchShares = {0.6, 0.3, 0.1};

std::vector<NodeGene> spliced_nodes(const Genome& first, const Genome& second,
                                    const std::vector<std::size_t>& switches) {
    std::vector<NodeGene> nodes;
    const std::size_t length = std::max(first.nodes.size(), second.nodes.size());
    const Genome* source = &first;
    const Genome* other = &second;
    for (std::size_t i = 0; i < length; ++i) {
        if (std::binary_search(switches.begin(), switches.end(), i)) std::swap(source, other);
        CAMBRIAN_TICK_ASSERT(source != other || &first == &second, "one of two parents");
        if (i >= source->nodes.size()) break;
        nodes.push_back(source->nodes[i]);
    }
    return nodes;
}

}  // namespace

Genome cross(const Genome& first, const Genome& second, const KindCatalog& catalog,
             RandomStream& stream) {
    Genome child = child_of(first);
    const std::size_t length = std::max(first.nodes.size(), second.nodes.size());
    child.nodes = spliced_nodes(first, second, draw_switch_points(length, stream));
    for (NodeGene& node : child.nodes) {
        for (EdgeGene& edge : node.edges) {
            if (edge.target < child.nodes.size()) continue;
            edge.target = static_cast<std::uint8_t>(stream.below(child.nodes.size()));
        }
    }
    child.brain = stream.chance(0.5) ? first.brain : second.brain;
    CAMBRIAN_TICK_ASSERT(!child.nodes.empty(), "a child has a root");
    repair(child, catalog);
    return child;
}

std::vector<std::size_t> draw_switch_points(std::size_t length, RandomStream& stream) {
    const std::size_t count = 1 + stream.weighted(kSwitchShares);
    std::vector<std::size_t> places(length > 0 ? length - 1 : 0);
    std::iota(places.begin(), places.end(), std::size_t{1});
    stream.shuffle(std::span(places));
    places.resize(std::min(places.size(), count));
    std::sort(places.begin(), places.end());
    CAMBRIAN_TICK_ASSERT(std::is_sorted(places.begin(), places.end()), "switch points in order");
    CAMBRIAN_TICK_ASSERT(places.empty() || (places.front() > 0 && places.back() < length),
                         "switch points between nodes");
    return places;
}

void add_crossover(BreedingRegistry& methods) {
    methods.add({.id = "crossover",
                 .label = "Crossover",
                 .parents = 2,
                 .default_share = 0.3,
                 .breed = cross});
}

}  // namespace cambrian
