#include "genome/founders/random_genome.h"

#include "core/assert.h"
#include "genome/founders/random_gene.h"
#include "genome/founders/rhythmic_genome.h"
#include "genome/gene_fields.h"

#include <algorithm>

namespace cambrian {
namespace {

constexpr int kRedraws = 20;              // attempts to get a movable joint
constexpr double kSecondLimbShare = 0.6;  // share of symmetric nodes that get a second edge at once
constexpr int kMaxExtraEdges = 2;
constexpr int kMostNodes = static_cast<int>(gene_range::kMaxNodes);

bool has_room(const NodeGene& node) {
    return node.edges.size() < gene_range::kMaxEdges;
}

// Returns an earlier node with room for an edge. There always is one, since edges have room for
// more nodes than the limit.
NodeGene& random_parent(Genome& genome, std::size_t child, RandomStream& stream) {
    std::vector<std::size_t> candidates;
    for (std::size_t i = 0; i < child; ++i) {
        if (has_room(genome.nodes[i])) candidates.push_back(i);
    }
    CAMBRIAN_TICK_ASSERT(!candidates.empty(), "fewer nodes than edges fit");
    return genome.nodes[stream.pick(candidates)];
}

void connect(Genome& genome, const GenePool& pool, RandomStream& stream) {
    for (std::size_t child = 1; child < genome.nodes.size(); ++child) {
        NodeGene& parent = random_parent(genome, child, stream);
        const EdgeGene edge = random_edge(child, pool, stream);
        parent.edges.push_back(edge);
        const bool second = genome.nodes[child].symmetric && stream.chance(kSecondLimbShare);
        if (second && has_room(parent)) parent.edges.push_back(edge);
    }
    for (int extra = stream.between(0, kMaxExtraEdges); extra > 0; --extra) {
        NodeGene& parent = stream.pick(genome.nodes);
        const EdgeGene edge = random_edge(stream.below(genome.nodes.size()), pool, stream);
        if (has_room(parent)) parent.edges.push_back(edge);
    }
}

Genome draw_genome(const GenePool& pool, RandomStream& stream) {
    const int least = std::clamp(pool.settings.min_nodes, 1, kMostNodes);
    const int most = std::clamp(pool.settings.max_nodes, least, kMostNodes);
    Genome genome;
    for (int count = stream.between(least, most); count > 0; --count)
        genome.nodes.push_back(random_node(pool, stream));
    const int neurons = stream.between(0, std::max(pool.settings.max_brain_neurons, 0));
    for (int i = 0; i < neurons; ++i)
        genome.brain.push_back(random_neuron(SourceScope::kBrain, pool, stream));
    for (const GeneField<Genome>& field : genome_fields(pool.catalog.dimensions))
        genome.*field.value = draw(field.rule, pool.settings, stream);
    connect(genome, pool, stream);
    genome.hue = stream.uniform();
    CAMBRIAN_TICK_ASSERT(!genome.nodes.empty(), "a genome has a root");
    repair(genome, pool.catalog);
    return genome;
}

// Every node except the root grows where an edge leads to it; the root grows again only if it
// recurs.
bool has_movable_joint(const Genome& genome, const KindCatalog& catalog) {
    for (const NodeGene& node : genome.nodes) {
        for (const EdgeGene& edge : node.edges) {
            CAMBRIAN_TICK_ASSERT(edge.target < genome.nodes.size(), "an edge leads to a node");
            const NodeGene& child = genome.nodes[edge.target];
            const bool grows = edge.target != 0 || child.recursion_limit > 1;
            if (grows && catalog.joints[child.joint].degrees_of_freedom > 0) return true;
        }
    }
    return false;
}

}  // namespace

Genome random_genome(const FounderSettings& settings, const KindCatalog& catalog,
                     RandomStream& stream) {
    const GenePool pool{settings, catalog};
    const bool rhythmic = settings.rhythmic_share > 0.0 && may_be_rhythmic(pool) &&
                          stream.chance(settings.rhythmic_share);
    const auto draw_one = rhythmic ? rhythmic_genome : draw_genome;
    Genome genome = draw_one(pool, stream);
    for (int draw = 0; draw < kRedraws && !has_movable_joint(genome, catalog); ++draw)
        genome = draw_one(pool, stream);
    CAMBRIAN_TICK_ASSERT(validate(genome, catalog).empty(), "founders are valid");
    return genome;
}

}  // namespace cambrian
