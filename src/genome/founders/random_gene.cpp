#include "genome/founders/random_gene.h"

#include "core/assert.h"
#include "genome/founders/enabled_kinds.h"
#include "genome/gene_fields.h"

#include <algorithm>
#include <array>

namespace cambrian {
namespace {

// Shares of the kinds of source, in the order of SourceKind.
using SourceShares = std::array<double, kSourceKindCount>;
constexpr SourceShares kPartShares = {.30, .25, .17, .10, .04, .05, .03, .06, 0, 0};
constexpr SourceShares kBrainShares = {.25, 0, 0, 0, 0, 0, 0, .45, .15, .15};

constexpr double kReflectShare = 0.2;
constexpr double kTerminalShare = 0.15;
constexpr double kSingleOccurrenceShare = 0.6;  // share of nodes with recursion limit 1
constexpr double kFounderOrganShare = 0.15;     // share of parts with an organ of an enabled kind
constexpr double kFounderEffectorShare = 0.6;   // share of effectors that read a local neuron

template <class Gene>
void draw_fields(Gene& gene, std::span<const GeneField<Gene>> fields,
                 const FounderSettings& settings, RandomStream& stream) {
    for (const GeneField<Gene>& field : fields)
        gene.*field.value = fit(draw(field.rule, settings, stream), field.rule);
}

bool may_draw(SourceKind kind, SourceScope scope, const GenePool& pool) {
    return is_enabled(kind, scope, pool.settings, pool.catalog);
}

double draw_parameter(const FieldRule& rule, RandomStream& stream) {
    if (!rule.whole) return stream.uniform(rule.low, rule.high);
    return rule.low + stream.between(0, static_cast<int>(rule.high - rule.low));
}

// Draws nothing if no kind of organ is enabled.
void draw_organs(NodeGene& node, const GenePool& pool, RandomStream& stream) {
    for (const std::uint8_t kind : enabled_organs(pool.settings, pool.catalog)) {
        const bool grows = stream.chance(kFounderOrganShare);
        if (grows && node.organs.size() < gene_range::kMaxOrgans)
            node.organs.push_back(random_organ(kind, node, pool, stream));
    }
}

// Draws the mirror axis and the further degrees of freedom of a part in space.
void draw_space(NodeGene& node, const GenePool& pool, RandomStream& stream) {
    if (stream.chance(0.5)) node.mirror_axis = MirrorAxis::kDepth;
    const int degrees = pool.catalog.joints[node.joint].degrees_of_freedom;
    for (int degree = 1; degree < degrees; ++degree) {
        DegreeGene& further = node.further.emplace_back();
        draw_fields(further, degree_fields(), pool.settings, stream);
        draw_fields(further.effector, input_fields(), pool.settings, stream);
        further.effector.source = random_effector_source(node, kFounderEffectorShare, pool, stream);
    }
}

std::uint8_t random_reference(RandomStream& stream) {
    return static_cast<std::uint8_t>(stream.below(gene_range::kMaxReference + 1));
}

}  // namespace

SourceRef random_source(SourceScope scope, const GenePool& pool, RandomStream& stream) {
    const SourceShares& usual = scope == SourceScope::kPart ? kPartShares : kBrainShares;
    const auto enabled = enabled_references(scope, pool.settings, pool.catalog);
    if (enabled.empty()) return {};
    SourceShares shares{};
    for (const SourceKind kind : enabled)
        shares[static_cast<std::size_t>(kind)] = usual[static_cast<std::size_t>(kind)];
    SourceRef source;
    source.kind = SourceKind(stream.weighted(shares));
    const auto channels = enabled_channels(pool.settings, pool.catalog);
    source.index = source_rule(source.kind).reads == SourceReads::kSensor
                       ? stream.pick(channels)
                       : random_reference(stream);
    source.child = random_reference(stream);
    source.node = random_reference(stream);
    source.instance = random_reference(stream);
    return canonical(source, scope);
}

InputGene random_input(SourceScope scope, const GenePool& pool, RandomStream& stream) {
    InputGene input;
    input.source = random_source(scope, pool, stream);
    draw_fields(input, input_fields(), pool.settings, stream);
    return input;
}

InputGene random_function_input(std::size_t function, std::size_t input, SourceScope scope,
                                const GenePool& pool, RandomStream& stream) {
    CAMBRIAN_TICK_ASSERT(function < pool.catalog.functions.size(), "a function of the catalog");
    const auto& hints = pool.catalog.functions[function].founder_inputs;
    if (input < hints.size() && may_draw(SourceKind::kConstant, scope, pool) &&
        stream.chance(hints[input].probability)) {
        return {.source = {}, .weight = stream.uniform(hints[input].low, hints[input].high)};
    }
    return random_input(scope, pool, stream);
}

NeuronGene random_neuron(SourceScope scope, const GenePool& pool, RandomStream& stream) {
    const auto functions = enabled_functions(pool.settings, pool.catalog);
    NeuronGene neuron;
    CAMBRIAN_TICK_ASSERT(!functions.empty(), "some function is enabled");
    neuron.function = stream.pick(functions);
    const auto arity = static_cast<std::size_t>(pool.catalog.functions[neuron.function].arity);
    for (std::size_t i = 0; i < arity; ++i)
        neuron.inputs.push_back(random_function_input(neuron.function, i, scope, pool, stream));
    return neuron;
}

SourceRef random_effector_source(const NodeGene& node, double local_neuron_share,
                                 const GenePool& pool, RandomStream& stream) {
    if (!node.neurons.empty() && may_draw(SourceKind::kLocalNeuron, SourceScope::kPart, pool) &&
        stream.chance(local_neuron_share)) {
        return own_neuron(SourceScope::kPart, stream.below(node.neurons.size()));
    }
    return random_source(SourceScope::kPart, pool, stream);
}

std::uint8_t random_effector_kind(const KindCatalog& catalog, RandomStream& stream) {
    if (catalog.effectors.size() < 2) return 0;
    return static_cast<std::uint8_t>(stream.below(catalog.effectors.size()));
}

std::uint8_t random_joint(const GenePool& pool, RandomStream& stream) {
    std::vector<std::uint8_t> moving;
    std::vector<std::uint8_t> rigid;
    for (const std::uint8_t joint : enabled_joints(pool.settings, pool.catalog)) {
        (pool.catalog.joints[joint].degrees_of_freedom > 0 ? moving : rigid).push_back(joint);
    }
    CAMBRIAN_TICK_ASSERT(!rigid.empty() || !moving.empty(), "some joint is enabled");
    const bool moves = stream.chance(pool.settings.moving_share);
    if (rigid.empty() || (moves && !moving.empty())) return stream.pick(moving);
    return stream.pick(rigid);
}

OrganGene random_organ(std::uint8_t kind, const NodeGene& node, const GenePool& pool,
                       RandomStream& stream) {
    CAMBRIAN_TICK_ASSERT(kind < pool.catalog.organs.size(), "an organ of the catalog");
    OrganGene organ;
    organ.kind = kind;
    const std::vector<FieldRule>& rules = pool.catalog.organs[kind].parameters;
    for (std::size_t i = 0; i < rules.size(); ++i)
        organ.parameters[i] = draw_parameter(rules[i], stream);
    draw_fields(organ.input, input_fields(), pool.settings, stream);
    organ.input.source = random_effector_source(node, kFounderEffectorShare, pool, stream);
    return organ;
}

NodeGene random_node(const GenePool& pool, RandomStream& stream) {
    const FounderSettings& settings = pool.settings;
    NodeGene node;
    draw_fields(node, node_fields(pool.catalog.dimensions), settings, stream);
    node.joint = random_joint(pool, stream);
    const int most = std::clamp(settings.max_recursion, 1, gene_range::kMaxRecursion);
    node.recursion_limit = stream.chance(kSingleOccurrenceShare) ? 1 : stream.between(1, most);
    node.symmetric = stream.chance(settings.symmetric_share);
    node.mirror_axis = stream.chance(0.5) ? MirrorAxis::kAlong : MirrorAxis::kAcross;
    const int neurons = stream.between(0, std::max(settings.max_node_neurons, 0));
    for (int i = 0; i < neurons; ++i)
        node.neurons.push_back(random_neuron(SourceScope::kPart, pool, stream));
    node.effector_kind = random_effector_kind(pool.catalog, stream);
    draw_fields(node.effector, input_fields(), settings, stream);
    node.effector.source = random_effector_source(node, kFounderEffectorShare, pool, stream);
    draw_organs(node, pool, stream);
    node.uid = static_cast<std::uint32_t>(stream.bits() >> 32);
    if (pool.catalog.dimensions == 3) draw_space(node, pool, stream);
    return node;
}

EdgeGene random_edge(std::size_t target, const GenePool& pool, RandomStream& stream) {
    EdgeGene edge;
    CAMBRIAN_TICK_ASSERT(target <= 2 * gene_range::kMaxNodes, "a node an edge can name");
    edge.target = static_cast<std::uint8_t>(target);
    draw_fields(edge, edge_fields(pool.catalog.dimensions), pool.settings, stream);
    edge.reflect = stream.chance(kReflectShare);
    edge.terminal_only = stream.chance(kTerminalShare);
    if (pool.catalog.dimensions == 3) edge.reflect_depth = stream.chance(kReflectShare);
    return edge;
}

}  // namespace cambrian
