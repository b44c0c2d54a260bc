#include "breeding/gene_sites.h"
#include "breeding/mutations/operators.h"

#include <fmt/core.h>

namespace cambrian {
namespace {

// Share of new edges that are copies of another edge of the same node.
constexpr double kDuplicateShare = 0.4;

// A copy of an edge to a symmetric node keeps its position. In this way a pair of limbs arises.
EdgeGene duplicate_of(const EdgeGene& original, const Genome& genome,
                      const MutationContext& context, RandomStream& stream) {
    EdgeGene copy = original;
    if (!genome.nodes[copy.target].symmetric) {
        copy.position = random_edge(copy.target, pool_of(context), stream).position;
    }
    return copy;
}

bool add_edge(Genome& genome, const MutationContext& context, RandomStream& stream,
              MutationRecord& record) {
    const bool duplicate = stream.chance(kDuplicateShare);
    auto nodes = nodes_with_room(genome);
    if (duplicate) {
        std::erase_if(nodes, [&](std::size_t node) { return genome.nodes[node].edges.empty(); });
    }
    if (nodes.empty()) return false;
    const std::size_t node = stream.pick(nodes);
    std::vector<EdgeGene>& edges = genome.nodes[node].edges;
    const EdgeGene edge =
        duplicate ? duplicate_of(stream.pick(edges), genome, context, stream)
                  : random_edge(stream.below(genome.nodes.size()), pool_of(context), stream);
    edges.push_back(edge);
    record.place = fmt::format("part {}", node);
    record.to = fmt::format("{} edge to part {}", duplicate ? "second" : "new", edge.target);
    return true;
}

bool remove_edge(Genome& genome, const MutationContext& /*context*/, RandomStream& stream,
                 MutationRecord& record) {
    const auto sites = edge_sites(genome);
    if (sites.empty()) return false;
    const EdgeSite& site = stream.pick(sites);
    record.place = site.in_words();
    record.from = fmt::format("to part {}", site.in(genome).target);
    record.to = "removed";
    std::vector<EdgeGene>& edges = genome.nodes[site.node].edges;
    edges.erase(edges.begin() + static_cast<std::ptrdiff_t>(site.edge));
    return true;
}

}  // namespace

void add_connection_operators(MutationRegistry& mutations) {
    mutations.add({"add-edge", "New attachment", MutationPhase::kConnections,
                   MutationSubject::kBody, 6, add_edge});
    mutations.add({"remove-edge", "Removed attachment", MutationPhase::kConnections,
                   MutationSubject::kBody, 5, remove_edge});
}

}  // namespace cambrian
