#include "sketch/rhythm.h"

#include "core/assert.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace cambrian {
namespace {

constexpr double kSamePhase = 1e-6;                   // cycles
constexpr std::string_view kSine = "oscillate-wave";  // inputs: frequency, phase in cycles

std::uint8_t sine_function(const KindCatalog& catalog) {
    const auto found = std::find_if(catalog.functions.begin(), catalog.functions.end(),
                                    [](const FunctionEntry& entry) { return entry.id == kSine; });
    CAMBRIAN_ASSERT(found != catalog.functions.end(), "the program has sines");
    return static_cast<std::uint8_t>(found - catalog.functions.begin());
}

// Returns the nodes whose joints move, in the order of their first joints along x.
std::vector<std::uint8_t> moving_nodes(const BodySketch& sketch) {
    struct Place {
        double x;
        std::uint8_t node;
    };
    std::vector<Place> places;
    for (std::size_t i = 1; i < sketch.body.parts.size(); ++i) {
        const std::uint8_t node = sketch.body.parts[i].node;
        const bool known = std::any_of(places.begin(), places.end(),
                                       [node](const Place& place) { return place.node == node; });
        if (!known && degrees_of(sketch.body.plan.parts[i]) > 0)
            places.push_back({joint_place(sketch, i).x(), node});
    }
    std::stable_sort(places.begin(), places.end(),
                     [](const Place& a, const Place& b) { return a.x < b.x; });
    std::vector<std::uint8_t> nodes;
    for (const Place& place : places)
        nodes.push_back(place.node);
    return nodes;
}

// Returns the node's neuron that its joint follows if that is a sine of constants, or null.
const NeuronGene* followed_sine(const NodeGene& node, std::uint8_t sine) {
    const SourceRef& source = node.effector.source;
    if (source.kind != SourceKind::kLocalNeuron || source.index >= node.neurons.size())
        return nullptr;
    const NeuronGene& neuron = node.neurons[source.index];
    const auto is_constant = [](const InputGene& input) {
        return input.source.kind == SourceKind::kConstant;
    };
    if (neuron.function != sine ||
        !std::all_of(neuron.inputs.begin(), neuron.inputs.end(), is_constant))
        return nullptr;
    return &neuron;
}

// Returns a phase between -1/2 and 1/2 cycle.
double wrapped(double cycles) {
    return cycles - std::floor(cycles + 0.5);
}

void follow_sine(NodeGene& node, std::uint8_t sine, double frequency, double phase, double swing) {
    const NeuronGene neuron{
        .function = sine,
        .inputs = {{.source = {}, .weight = frequency}, {.source = {}, .weight = phase}}};
    if (followed_sine(node, sine) != nullptr) {
        node.neurons[node.effector.source.index] = neuron;
    } else {
        if (node.neurons.size() == gene_range::kMaxNodeNeurons) node.neurons.pop_back();
        node.neurons.push_back(neuron);
        node.effector.source = {.kind = SourceKind::kLocalNeuron,
                                .index = static_cast<std::uint8_t>(node.neurons.size() - 1)};
    }
    node.effector.weight = swing;
}

}  // namespace

Result<Genome> with_rhythm(const BodySketch& sketch, const Rhythm& rhythm,
                           const SketchRules& rules) {
    const std::vector<std::uint8_t> nodes = moving_nodes(sketch);
    if (nodes.empty()) return Error{"a rhythm needs a joint; draw a part that grows from another"};
    const std::uint8_t sine = sine_function(rules.kinds.catalog);
    const double frequency = std::clamp(rhythm.frequency, kLeastFrequency, kMostFrequency);
    const double swing = std::clamp(rhythm.swing, kLeastRhythmSwing, kMostRhythmSwing);
    const double wave = std::clamp(rhythm.wave, -kMostWave, kMostWave);
    Genome genome = sketch.genome;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(nodes.size());
        follow_sine(genome.nodes[nodes[i]], sine, frequency, wrapped(wave * share), swing);
    }
    return genome;
}

std::optional<Rhythm> rhythm_of(const BodySketch& sketch, const SketchRules& rules) {
    const std::vector<std::uint8_t> nodes = moving_nodes(sketch);
    if (nodes.empty()) return {};
    const std::uint8_t sine = sine_function(rules.kinds.catalog);
    std::vector<Rhythm> beats;  // of each node; the wave is its phase
    for (const std::uint8_t index : nodes) {
        const NodeGene& node = sketch.genome.nodes[index];
        const NeuronGene* neuron = followed_sine(node, sine);
        if (neuron == nullptr) return {};
        beats.push_back({neuron->inputs[0].weight, node.effector.weight, neuron->inputs[1].weight});
    }
    Rhythm rhythm = beats.front();
    const auto count = static_cast<double>(beats.size());
    // Half a cycle counts as forwards.
    rhythm.wave = beats.size() > 1 ? -wrapped(beats[0].wave - beats[1].wave) * count : 1.0;
    for (std::size_t i = 0; i < beats.size(); ++i) {
        const double phase = rhythm.wave * static_cast<double>(i) / count;
        if (beats[i].frequency != rhythm.frequency || beats[i].swing != rhythm.swing ||
            std::fabs(wrapped(beats[i].wave - phase)) > kSamePhase)
            return {};
    }
    return rhythm;
}

}  // namespace cambrian
