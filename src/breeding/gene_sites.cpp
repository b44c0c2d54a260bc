#include "breeding/gene_sites.h"

#include "core/assert.h"

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

}  // namespace

std::vector<NeuronGene>& NeuronListSite::in(Genome& genome) const {
    return scope == SourceScope::kPart ? genome.nodes[node].neurons : genome.brain;
}

std::size_t NeuronListSite::limit() const {
    return scope == SourceScope::kPart ? gene_range::kMaxNodeNeurons : gene_range::kMaxBrainNeurons;
}

std::string NeuronListSite::in_words() const {
    return scope == SourceScope::kPart ? "part " + std::to_string(node) : "brain";
}

std::string NeuronSite::in_words() const {
    return list.in_words() + " neuron " + std::to_string(neuron);
}

InputGene& InputSite::in(Genome& genome) const {
    if (effector) return genome.nodes[list.node].effector;
    CAMBRIAN_TICK_ASSERT(neuron < list.in(genome).size(), "a neuron of the list");
    CAMBRIAN_TICK_ASSERT(input < list.in(genome)[neuron].inputs.size(), "an input of it");
    return list.in(genome)[neuron].inputs[input];
}

std::string InputSite::in_words() const {
    if (effector) return list.in_words() + " effector";
    return NeuronSite{list, neuron}.in_words() + " input " + std::to_string(input);
}

std::string EdgeSite::in_words() const {
    return "part " + std::to_string(node) + " edge " + std::to_string(edge);
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
        if (list.scope == SourceScope::kPart) sites.push_back({list, true, 0, 0});
        const std::vector<NeuronGene>& neurons = neurons_of(genome, list);
        for (std::size_t neuron = 0; neuron < neurons.size(); ++neuron) {
            for (std::size_t input = 0; input < neurons[neuron].inputs.size(); ++input)
                sites.push_back({list, false, neuron, input});
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

std::vector<std::size_t> nodes_with_room(const Genome& genome) {
    std::vector<std::size_t> nodes;
    for (std::size_t i = 0; i < genome.nodes.size(); ++i) {
        if (genome.nodes[i].edges.size() < gene_range::kMaxEdges) nodes.push_back(i);
    }
    return nodes;
}

}  // namespace cambrian
