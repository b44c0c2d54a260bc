#include "genome/genome.h"

#include "core/hash.h"

namespace cambrian {
namespace {

// Adding 0 maps -0 to 0, since these are equal genes.
void add_real(Hash64& hash, double number) {
    hash.add(number + 0.0);
}

void add_input(Hash64& hash, const InputGene& input) {
    hash.add_byte(static_cast<std::uint8_t>(input.source.kind));
    hash.add_byte(input.source.index);
    hash.add_byte(input.source.child);
    hash.add_byte(input.source.node);
    hash.add_byte(input.source.instance);
    add_real(hash, input.weight);
}

void add_neurons(Hash64& hash, const std::vector<NeuronGene>& neurons) {
    hash.add(std::uint64_t{neurons.size()});
    for (const NeuronGene& neuron : neurons) {
        hash.add_byte(neuron.function);
        hash.add(std::uint64_t{neuron.inputs.size()});
        for (const InputGene& input : neuron.inputs)
            add_input(hash, input);
    }
}

void add_edge(Hash64& hash, const EdgeGene& edge) {
    hash.add_byte(edge.target);
    add_real(hash, edge.position);
    add_real(hash, edge.angle);
    add_real(hash, edge.scale);
    hash.add_byte(edge.reflect ? 1 : 0);
    hash.add_byte(edge.terminal_only ? 1 : 0);
}

// A mark that no count of neurons has comes first, so that nodes without organs keep the hash that
// they had before there were any.
void add_organs(Hash64& hash, const std::vector<OrganGene>& organs) {
    if (organs.empty()) return;
    constexpr std::size_t mark = 0x80;
    hash.add_byte(static_cast<std::uint8_t>(mark + organs.size()));
    for (const OrganGene& organ : organs) {
        hash.add_byte(organ.kind);
        add_input(hash, organ.input);
        for (const double parameter : organ.parameters)
            add_real(hash, parameter);
    }
}

void add_node(Hash64& hash, const NodeGene& node) {
    add_real(hash, node.length);
    add_real(hash, node.width);
    hash.add_byte(node.joint);
    add_real(hash, node.limit_low);
    add_real(hash, node.limit_high);
    hash.add_byte(static_cast<std::uint8_t>(node.recursion_limit));
    hash.add_byte(node.symmetric ? 1 : 0);
    hash.add_byte(static_cast<std::uint8_t>(node.mirror_axis));
    if (node.effector_kind != 0) hash.add_byte(node.effector_kind);
    add_input(hash, node.effector);
    add_organs(hash, node.organs);
    add_neurons(hash, node.neurons);
    hash.add(std::uint64_t{node.edges.size()});
    for (const EdgeGene& edge : node.edges)
        add_edge(hash, edge);
}

// Nothing of the plane, so that its hashes stay.
void add_space(Hash64& hash, const Genome& genome) {
    add_real(hash, genome.root_tilt);
    add_real(hash, genome.root_roll);
    for (const NodeGene& node : genome.nodes) {
        add_real(hash, node.depth);
        for (const DegreeGene& degree : node.further) {
            add_real(hash, degree.limit_low);
            add_real(hash, degree.limit_high);
            add_input(hash, degree.effector);
        }
        for (const EdgeGene& edge : node.edges) {
            for (const double number : {edge.height, edge.tilt, edge.roll})
                add_real(hash, number);
            hash.add_byte(edge.reflect_depth ? 1 : 0);
        }
    }
}

}  // namespace

bool operator==(const NodeGene& a, const NodeGene& b) {
    return a.length == b.length && a.width == b.width && a.joint == b.joint &&
           a.limit_low == b.limit_low && a.limit_high == b.limit_high &&
           a.recursion_limit == b.recursion_limit && a.symmetric == b.symmetric &&
           a.mirror_axis == b.mirror_axis && a.effector_kind == b.effector_kind &&
           a.effector == b.effector && a.organs == b.organs && a.neurons == b.neurons &&
           a.edges == b.edges && a.depth == b.depth && a.further == b.further;
}

bool operator==(const Genome& a, const Genome& b) {
    return a.nodes == b.nodes && a.brain == b.brain && a.root_angle == b.root_angle &&
           a.reproduction == b.reproduction && a.root_tilt == b.root_tilt &&
           a.root_roll == b.root_roll && a.dimensions == b.dimensions;
}

std::uint64_t genome_hash(const Genome& genome) {
    Hash64 hash;
    hash.add(std::uint64_t{genome.nodes.size()});
    for (const NodeGene& node : genome.nodes)
        add_node(hash, node);
    add_neurons(hash, genome.brain);
    add_real(hash, genome.root_angle);
    hash.add_byte(genome.reproduction);
    if (genome.dimensions == 3) add_space(hash, genome);
    return hash.value();
}

Genome lifted(const Genome& planar, double depth) {
    Genome genome = planar;
    genome.dimensions = 3;
    for (NodeGene& node : genome.nodes)
        node.depth = depth > 0.0 ? depth : node.width;
    return genome;
}

}  // namespace cambrian
