#pragma once

// The places in a genome that mutation chooses among, each with its description.

#include "core/random.h"
#include "genome/genome.h"
#include "genome/source_rules.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace cambrian {

// A list of neurons and its owner: a node or the central brain.
struct NeuronListSite {
    SourceScope scope = SourceScope::kPart;
    std::size_t node = 0;  // for SourceScope::kPart

    std::vector<NeuronGene>& in(Genome& genome) const;
    std::size_t limit() const;
    std::string in_words() const;  // "part 2" or "brain"
};

struct NeuronSite {
    NeuronListSite list;
    std::size_t neuron = 0;

    NeuronGene& in(Genome& genome) const { return list.in(genome)[neuron]; }
    std::string in_words() const;  // "part 2 neuron 0"
};

enum class InputOwner : std::uint8_t { kNeuron, kEffector, kOrgan };

// A weighted link into a neuron, an effector or an organ.
struct InputSite {
    NeuronListSite list;  // neurons of the part or brain that has the link
    InputOwner owner = InputOwner::kNeuron;
    std::size_t index = 0;  // of the neuron, the degree of freedom or the organ
    std::size_t input = 0;  // of a neuron

    InputGene& in(Genome& genome) const;
    // "part 2 neuron 0 input 1", "part 2 effector", "part 2 effector 2" or "part 2 organ 0"
    std::string in_words() const;
};

struct OrganGeneSite {
    std::size_t node = 0;
    std::size_t organ = 0;

    OrganGene& in(Genome& genome) const { return genome.nodes[node].organs[organ]; }
    std::string in_words() const;  // "part 2 organ 0"
};

struct EdgeSite {
    std::size_t node = 0;
    std::size_t edge = 0;

    EdgeGene& in(Genome& genome) const { return genome.nodes[node].edges[edge]; }
    std::string in_words() const;  // "part 2 edge 0"
};

std::vector<NeuronSite> neuron_sites(const Genome& genome);
std::vector<InputSite> input_sites(const Genome& genome);
std::vector<EdgeSite> edge_sites(const Genome& genome);
std::vector<OrganGeneSite> organ_sites(const Genome& genome);

// Return the nodes that have room for another edge, another organ or another neuron.
std::vector<std::size_t> nodes_with_room(const Genome& genome);
std::vector<std::size_t> nodes_with_room_for_organs(const Genome& genome);
std::vector<std::size_t> nodes_with_room_for_neurons(const Genome& genome);

}  // namespace cambrian
