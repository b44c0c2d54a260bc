#pragma once

#include "core/random.h"
#include "genome/genome.h"

#include <array>
#include <limits>

namespace cambrian {

inline double garbage_real(RandomStream& stream) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    constexpr std::array<double, 8> odd = {0.0,
                                           -0.0,
                                           infinity,
                                           -infinity,
                                           std::numeric_limits<double>::quiet_NaN(),
                                           1e300,
                                           -1e-300,
                                           3.14159265358979323846};
    return stream.chance(0.3) ? stream.pick(odd) : stream.uniform(-5.0, 5.0);
}

inline std::uint8_t garbage_byte(RandomStream& stream) {
    return static_cast<std::uint8_t>(stream.below(stream.chance(0.5) ? 20 : 256));
}

inline InputGene garbage_input(RandomStream& stream) {
    return {{SourceKind(stream.below(14)), garbage_byte(stream), garbage_byte(stream),
             garbage_byte(stream), garbage_byte(stream)},
            garbage_real(stream)};
}

inline std::vector<NeuronGene> garbage_neurons(RandomStream& stream) {
    std::vector<NeuronGene> neurons(stream.below(20));
    for (NeuronGene& neuron : neurons) {
        neuron.function = garbage_byte(stream);
        for (std::size_t i = stream.below(6); i > 0; --i)
            neuron.inputs.push_back(garbage_input(stream));
    }
    return neurons;
}

inline NodeGene garbage_node(RandomStream& stream) {
    NodeGene node;
    node.length = garbage_real(stream);
    node.width = garbage_real(stream);
    node.joint = garbage_byte(stream);
    node.limit_low = garbage_real(stream);
    node.limit_high = garbage_real(stream);
    node.recursion_limit = stream.between(-100, 100);
    node.symmetric = stream.chance(0.5);
    node.mirror_axis = MirrorAxis(stream.below(4));
    node.effector = garbage_input(stream);
    for (std::size_t i = stream.below(6); i > 0; --i) {
        node.organs.push_back({static_cast<std::uint8_t>(stream.below(4)),
                               garbage_input(stream),
                               {garbage_real(stream), garbage_real(stream)}});
    }
    node.neurons = garbage_neurons(stream);
    for (std::size_t i = stream.below(9); i > 0; --i) {
        node.edges.push_back({garbage_byte(stream), garbage_real(stream), garbage_real(stream),
                              garbage_real(stream), stream.chance(0.5), stream.chance(0.5)});
    }
    return node;
}

// Returns a genome that violates any rules.
inline Genome garbage_genome(RandomStream& stream) {
    Genome genome;
    for (std::size_t i = stream.below(25); i > 0; --i)
        genome.nodes.push_back(garbage_node(stream));
    genome.brain = garbage_neurons(stream);
    genome.root_angle = garbage_real(stream);
    genome.reproduction = static_cast<std::uint8_t>(stream.below(6));
    genome.hue = garbage_real(stream);
    genome.name = std::string(stream.below(100), 'x');
    return genome;
}

}  // namespace cambrian
