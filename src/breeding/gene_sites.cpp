#include "breeding/gene_sites.h"

#include "core/assert.h"

#include <fmt/core.h>

namespace cambrian {
namespace {

std::vector<NeuronListSite> neuron_lists(const Genome& genome) {
    std::vector<NeuronListSite> lists;
    for (std::size_t node = 0; node < genome.nodes.size(); ++node)
        lists.push_back({SourceScope::kPart, node});
    lists.push_back({SourceScope::kBrain, 0});
    return lists;
}

const std::vector<NeuronGene>& neurons_of(const Genome& genome, const NeuronListSite& list) {
    return list.scope == SourceScope::kPart ? genome.nodes[list.node].neurons : genome.brain;
}

template <class Gene>
std::vector<std::size_t> nodes_with_fewer(const Genome& genome, std::vector<Gene> NodeGene::*genes,
                                          std::size_t limit) {
    std::vector<std::size_t> nodes;
    for (std::size_t i = 0; i < genome.nodes.size(); ++i) {
        if ((genome.nodes[i].*genes).size() < limit) nodes.push_back(i);
    }
    return nodes;
}

// Adds the links of a part into its effectors and its organs.
void add_part_inputs(const Genome& genome, const NeuronListSite& list,
                     std::vector<InputSite>& sites) {
    for (std::size_t degree = 0; degree <= genome.nodes[list.node].further.size(); ++degree)
        sites.push_back({list, InputOwner::kEffector, degree, 0});
    for (std::size_t organ = 0; organ < genome.nodes[list.node].organs.size(); ++organ)
        sites.push_back({list, InputOwner::kOrgan, organ, 0});
}

}  // namespace

std::vector<NeuronGene>& NeuronListSite::in(Genome& genome) const {
    return scope == SourceScope::kPart ? genome.nodes[node].neurons : genome.brain;
}

std::size_t NeuronListSite::limit() const {
    return scope == SourceScope::kPart ? gene_range::kMaxNodeNeurons : gene_range::kMaxBrainNeurons;
}

std::string NeuronListSite::in_words() const {
    return scope == SourceScope::kPart ? fmt::format("part {}", node) : "brain";
}

std::string NeuronSite::in_words() const {
    return fmt::format("{} neuron {}", list.in_words(), neuron);
}

InputGene& InputSite::in(Genome& genome) const {
    if (owner == InputOwner::kEffector) return effector_of(genome.nodes[list.node], index);
    if (owner == InputOwner::kOrgan) return OrganGeneSite{list.node, index}.in(genome).input;
    CAMBRIAN_TICK_ASSERT(index < list.in(genome).size(), "a neuron of the list");
    CAMBRIAN_TICK_ASSERT(input < list.in(genome)[index].inputs.size(), "an input of it");
    return list.in(genome)[index].inputs[input];
}

std::string InputSite::in_words() const {
    if (owner == InputOwner::kEffector)
        return list.in_words() +
               (index == 0 ? " effector" : fmt::format(" effector {}", index + 1));
    if (owner == InputOwner::kOrgan) return OrganGeneSite{list.node, index}.in_words();
    return fmt::format("{} input {}", NeuronSite{list, index}.in_words(), input);
}

std::string OrganGeneSite::in_words() const {
    return fmt::format("part {} organ {}", node, organ);
}

std::string EdgeSite::in_words() const {
    return fmt::format("part {} edge {}", node, edge);
}

std::vector<NeuronSite> neuron_sites(const Genome& genome) {
    std::vector<NeuronSite> sites;
    for (const NeuronListSite& list : neuron_lists(genome)) {
        for (std::size_t i = 0; i < neurons_of(genome, list).size(); ++i)
            sites.push_back({list, i});
    }
    return sites;
}

std::vector<InputSite> input_sites(const Genome& genome) {
    std::vector<InputSite> sites;
    for (const NeuronListSite& list : neuron_lists(genome)) {
        if (list.scope == SourceScope::kPart) add_part_inputs(genome, list, sites);
        const std::vector<NeuronGene>& neurons = neurons_of(genome, list);
        for (std::size_t neuron = 0; neuron < neurons.size(); ++neuron) {
            for (std::size_t input = 0; input < neurons[neuron].inputs.size(); ++input)
                sites.push_back({list, InputOwner::kNeuron, neuron, input});
        }
    }
    return sites;
}

std::vector<EdgeSite> edge_sites(const Genome& genome) {
    std::vector<EdgeSite> sites;
    for (std::size_t node = 0; node < genome.nodes.size(); ++node) {
        for (std::size_t edge = 0; edge < genome.nodes[node].edges.size(); ++edge)
            sites.push_back({node, edge});
    }
    return sites;
}

std::vector<OrganGeneSite> organ_sites(const Genome& genome) {
    std::vector<OrganGeneSite> sites;
    for (std::size_t node = 0; node < genome.nodes.size(); ++node) {
        for (std::size_t organ = 0; organ < genome.nodes[node].organs.size(); ++organ)
            sites.push_back({node, organ});
    }
    return sites;
}

std::vector<std::size_t> nodes_with_room(const Genome& genome) {
    return nodes_with_fewer(genome, &NodeGene::edges, gene_range::kMaxEdges);
}

std::vector<std::size_t> nodes_with_room_for_organs(const Genome& genome) {
    return nodes_with_fewer(genome, &NodeGene::organs, gene_range::kMaxOrgans);
}

std::vector<std::size_t> nodes_with_room_for_neurons(const Genome& genome) {
    return nodes_with_fewer(genome, &NodeGene::neurons, gene_range::kMaxNodeNeurons);
}

}  // namespace cambrian
