#include "breeding/gene_sites.h"
#include "breeding/mutations/operators.h"
#include "core/assert.h"
#include "genome/founders/enabled_kinds.h"
#include "genome/words.h"

#include <fmt/core.h>

namespace cambrian {
namespace {

constexpr double kCopyShare = 0.5;  // share of new nodes that are copies; the others are random
constexpr double kSecondEdgeShare = 0.5;  // share of symmetric new nodes that get a second edge
constexpr double kKeepSourceShare = 0.7;  // share of new neurons that pass the old source on

NodeGene new_node(const Genome& genome, const MutationContext& context, RandomStream& stream,
                  MutationRecord& record) {
    NodeGene node = random_node(pool_of(context), stream);
    if (!stream.chance(kCopyShare)) {
        record.to = "random part";
        return node;
    }
    const std::uint32_t uid = node.uid;
    const std::size_t original = stream.below(genome.nodes.size());
    node = genome.nodes[original];
    node.uid = uid;
    record.to = fmt::format("copy of part {}", original);
    return node;
}

bool add_node(Genome& genome, const MutationContext& context, RandomStream& stream,
              MutationRecord& record) {
    const auto parents = nodes_with_room(genome);
    if (genome.nodes.size() >= gene_range::kMaxNodes || parents.empty()) return false;
    const std::size_t parent = stream.pick(parents);
    CAMBRIAN_TICK_ASSERT(parent < genome.nodes.size(), "a node of the genome");
    const std::size_t index = genome.nodes.size();
    genome.nodes.push_back(new_node(genome, context, stream, record));
    std::vector<EdgeGene>& edges = genome.nodes[parent].edges;
    const EdgeGene edge = random_edge(index, pool_of(context), stream);
    edges.push_back(edge);
    const bool second = genome.nodes[index].symmetric && stream.chance(kSecondEdgeShare);
    if (second && edges.size() < gene_range::kMaxEdges) edges.push_back(edge);
    record.place = fmt::format("part {} new {}", parent, second ? "pair" : "child");
    return true;
}

// Returns whether new links may lead to neurons of the reader's own list.
bool may_hear_neighbors(SourceScope scope, const MutationContext& context) {
    return is_enabled(own_neuron_kind(scope), scope, context.founders, context.catalog);
}

bool add_neuron(Genome& genome, const MutationContext& context, RandomStream& stream,
                MutationRecord& record) {
    auto sites = input_sites(genome);
    const bool in_parts = may_hear_neighbors(SourceScope::kPart, context);
    const bool in_brain = may_hear_neighbors(SourceScope::kBrain, context);
    std::erase_if(sites, [&](const InputSite& site) {
        const bool may_hear = site.list.scope == SourceScope::kPart ? in_parts : in_brain;
        return !may_hear || site.list.in(genome).size() >= site.list.limit();
    });
    if (sites.empty()) return false;
    const InputSite& site = stream.pick(sites);
    const SourceRef old_source = site.in(genome).source;
    NeuronGene neuron = random_neuron(site.list.scope, pool_of(context), stream);
    if (stream.chance(kKeepSourceShare)) neuron.inputs[0].source = old_source;
    record.place = site.in_words();
    record.from = in_words(old_source, context.catalog);
    record.to = "new neuron " + context.catalog.functions[neuron.function].id;
    std::vector<NeuronGene>& list = site.list.in(genome);
    list.push_back(std::move(neuron));
    site.in(genome).source = own_neuron(site.list.scope, list.size() - 1);
    return true;
}

}  // namespace

void add_growth_operators(MutationRegistry& mutations) {
    mutations.add(
        {"add-node", "New part", MutationPhase::kGrowth, MutationSubject::kBody, 5, add_node});
    mutations.add({"add-neuron", "New neuron", MutationPhase::kGrowth, MutationSubject::kBrain, 7,
                   add_neuron});
}

}  // namespace cambrian
