#pragma once

#include "creature/fake_scene.h"
#include "creature/phenotype.h"
#include "genome/founders/random_genome.h"
#include "sensors/fake_surroundings.h"

namespace cambrian {

inline const Kinds& kinds() {
    static const Kinds all = make_kinds(builtin_neuron_functions(), builtin_sensors(),
                                        builtin_effectors(), builtin_organs(), fake_scene_kind());
    return all;
}

inline std::uint8_t function(std::string_view id) {
    return static_cast<std::uint8_t>(kinds().functions.index_of(id).value());
}

inline InputGene constant(double value) {
    return {{}, value};
}
inline InputGene local_neuron(std::size_t neuron, double weight = 1.0) {
    return {{SourceKind::kLocalNeuron, static_cast<std::uint8_t>(neuron)}, weight};
}
inline NeuronGene oscillator(double frequency, double phase = 0.0) {
    return {function("oscillate-wave"), {constant(frequency), constant(phase)}};
}

inline EdgeGene edge_to(std::size_t target, double position = 0.125, double angle = 0.0) {
    return {.target = static_cast<std::uint8_t>(target), .position = position, .angle = angle};
}

// Returns a node whose edges lead to the given nodes, straight from the middle of the far end.
inline NodeGene node_with(std::initializer_list<EdgeGene> edges, int recursion_limit = 1) {
    NodeGene node;
    node.edges = edges;
    node.recursion_limit = recursion_limit;
    return node;
}

inline Genome genome_of(std::initializer_list<NodeGene> nodes) {
    Genome genome;
    genome.nodes = nodes;
    CAMBRIAN_ASSERT(validate(genome, kinds().catalog).empty(), "a test's genome is valid");
    return genome;
}

// Returns a body with a pair of beating legs: creature/README.md 3, example (c).
inline Genome two_legs() {
    NodeGene leg;
    leg.symmetric = true;
    leg.limit_low = -0.4;
    leg.limit_high = 1.2;
    leg.neurons = {oscillator(1.0)};
    leg.effector = local_neuron(0);
    return genome_of({node_with({edge_to(1, 0.3, 0.4), edge_to(1, 0.8, -1.0)}), leg});
}

inline Phenotype express(const Genome& genome, const ExpressionSettings& settings = {}) {
    return express(genome, kinds(), settings, SceneSettings{});
}

}  // namespace cambrian
