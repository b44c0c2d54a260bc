// Grafting (breeding/README.md 8): a random edge of the first parent leads to a copy of a random
// node of the second and of all nodes that can be reached from it. The edge's own genes stay, so
// the new limb grows where the old one was. Nodes that can no longer be reached are removed.

#include "breeding/gene_sites.h"
#include "breeding/methods.h"
#include "core/assert.h"
#include "genome/founders/random_gene.h"
#include "genome/genome_graph.h"

namespace cambrian {
namespace {

// Appends copies of the donor's nodes that can be reached from `start`; returns the index of the
// copy of `start`.
std::size_t append_section(Genome& child, const Genome& donor, std::size_t start) {
    Genome section = donor;
    keep_nodes(section, breadth_first(donor, start));
    const std::size_t base = child.nodes.size();
    CAMBRIAN_ASSERT(base + section.nodes.size() <= 2 * gene_range::kMaxNodes,
                    "edges can name every node of two valid genomes");
    for (NodeGene& node : section.nodes) {
        for (EdgeGene& edge : node.edges)
            edge.target = static_cast<std::uint8_t>(edge.target + base);
        child.nodes.push_back(std::move(node));
    }
    return base;
}

Genome breed_grafting(const Genome& first, const Genome& second, const KindCatalog& catalog,
                      RandomStream& stream) {
    Genome child = child_of(first);
    auto sites = edge_sites(child);
    if (sites.empty()) {
        child.nodes[0].edges.push_back(random_edge(0, {FounderSettings{}, catalog}, stream));
        sites = edge_sites(child);
    }
    CAMBRIAN_TICK_ASSERT(!sites.empty(), "an edge leads to the organ");
    const EdgeSite site = stream.pick(sites);
    const std::size_t grafted = append_section(child, second, stream.below(second.nodes.size()));
    CAMBRIAN_TICK_ASSERT(grafted < child.nodes.size(), "a node of the child");
    site.in(child).target = static_cast<std::uint8_t>(grafted);
    repair(child, catalog);
    return child;
}

}  // namespace

void add_grafting(BreedingRegistry& methods) {
    methods.add({.id = "grafting",
                 .label = "Grafting",
                 .parents = 2,
                 .default_share = 0.3,
                 .breed = breed_grafting});
}

}  // namespace cambrian
