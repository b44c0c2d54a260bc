#include "genome/founders/rhythmic_genome.h"

#include "core/assert.h"
#include "genome/founders/enabled_kinds.h"
#include "genome/gene_fields.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace cambrian {
namespace {

constexpr double kLeastWeight = 0.3;  // of the link from an oscillator to its joint
constexpr double kMostWeight = 2.0;
constexpr double kNewLimbShare = 0.35;       // share of nodes that begin another limb at the root
constexpr double kSingleSegmentShare = 0.8;  // share of nodes that occur once; the others twice
constexpr int kMostSegments = static_cast<int>(gene_range::kMaxNodes);

// Returns the first enabled function that suggests constants for all its inputs, as oscillators do
// for frequency and phase.
std::optional<std::uint8_t> enabled_oscillator(const GenePool& pool) {
    for (const std::uint8_t function : enabled_functions(pool.settings, pool.catalog)) {
        const FunctionEntry& entry = pool.catalog.functions[function];
        if (entry.founder_inputs.size() == static_cast<std::size_t>(entry.arity)) return function;
    }
    return std::nullopt;
}

InputGene suggested_constant(const FounderConstant& hint, RandomStream& stream) {
    return {.source = {}, .weight = stream.uniform(hint.low, hint.high)};
}

// Adds an oscillator of that frequency to a node, or replaces its last neuron if there is no room.
// The effector follows it.
void follow_oscillator(NodeGene& node, InputGene& effector, std::uint8_t function,
                       const InputGene& frequency, const GenePool& pool, RandomStream& stream) {
    NeuronGene neuron{.function = function, .inputs = {frequency}};
    const auto& hints = pool.catalog.functions[function].founder_inputs;
    for (std::size_t i = 1; i < hints.size(); ++i)
        neuron.inputs.push_back(suggested_constant(hints[i], stream));
    if (node.neurons.size() == gene_range::kMaxNodeNeurons) node.neurons.pop_back();
    node.neurons.push_back(std::move(neuron));
    effector.source = own_neuron(SourceScope::kPart, node.neurons.size() - 1);
    effector.weight = stream.uniform(kLeastWeight, kMostWeight);
}

// Each node begins a limb at the root, single or in a mirrored pair, or continues the limb before.
void connect_limbs(Genome& genome, const GenePool& pool, RandomStream& stream) {
    for (std::size_t node = 1; node < genome.nodes.size(); ++node) {
        const bool begins = node == 1 || stream.chance(kNewLimbShare);
        std::vector<EdgeGene>& edges = genome.nodes[begins ? 0 : node - 1].edges;
        EdgeGene edge = random_edge(node, pool, stream);
        edge.reflect = false;
        edge.terminal_only = false;
        edge.reflect_depth = false;
        const bool paired = begins && stream.chance(pool.settings.symmetric_share);
        genome.nodes[node].symmetric = paired;
        for (int copies = paired ? 2 : 1; copies > 0 && edges.size() < gene_range::kMaxEdges;
             --copies)
            edges.push_back(edge);
    }
}

}  // namespace

bool may_be_rhythmic(const GenePool& pool) {
    const auto enabled = [&](SourceKind kind) {
        return is_enabled(kind, SourceScope::kPart, pool.settings, pool.catalog);
    };
    return enabled_oscillator(pool) && pool.settings.max_node_neurons > 0 &&
           enabled(SourceKind::kConstant) && enabled(SourceKind::kLocalNeuron);
}

Genome rhythmic_genome(const GenePool& pool, RandomStream& stream) {
    const std::optional<std::uint8_t> oscillator = enabled_oscillator(pool);
    CAMBRIAN_ASSERT(oscillator.has_value(), "the settings allow rhythmic genomes");
    const FounderSettings& settings = pool.settings;
    const int least = std::clamp(settings.min_nodes, 1, kMostSegments);
    const int most = std::clamp(settings.max_nodes, least, kMostSegments);
    const InputGene frequency =
        suggested_constant(pool.catalog.functions[*oscillator].founder_inputs.front(), stream);
    Genome genome;
    for (const GeneField<Genome>& field : genome_fields(pool.catalog.dimensions))
        genome.*field.value = draw(field.rule, settings, stream);
    for (int count = stream.between(least, most); count > 0; --count) {
        NodeGene node = random_node(pool, stream);
        node.recursion_limit =
            stream.chance(kSingleSegmentShare) ? 1 : std::clamp(2, 1, settings.max_recursion);
        follow_oscillator(node, node.effector, *oscillator, frequency, pool, stream);
        // Founders bend more than they twist.
        for (DegreeGene& degree : node.further) {
            follow_oscillator(node, degree.effector, *oscillator, frequency, pool, stream);
            degree.effector.weight *= stream.uniform();
        }
        genome.nodes.push_back(std::move(node));
    }
    connect_limbs(genome, pool, stream);
    genome.hue = stream.uniform();
    repair(genome, pool.catalog);
    return genome;
}

}  // namespace cambrian
