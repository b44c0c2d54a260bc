#include "core/assert.h"
#include "genome/gene_fields.h"
#include "genome/genome.h"
#include "genome/genome_graph.h"
#include "genome/source_rules.h"
#include "math/reflect.h"

#include <algorithm>
#include <cmath>

namespace cambrian {
namespace {

template <class Gene>
void fit_fields(Gene& gene, std::span<const GeneField<Gene>> fields) {
    for (const GeneField<Gene>& field : fields)
        gene.*field.value = fit(gene.*field.value, field.rule);
}

template <class Item>
void trim(std::vector<Item>& items, std::size_t limit) {
    if (items.size() > limit)
        items.erase(items.begin() + static_cast<std::ptrdiff_t>(limit), items.end());
}

void repair_input(InputGene& input, SourceScope scope) {
    fit_fields(input, input_fields());
    input.source = canonical(input.source, scope);
}

void repair_neuron(NeuronGene& neuron, SourceScope scope, const KindCatalog& catalog) {
    if (neuron.function >= catalog.functions.size()) neuron.function = 0;
    const auto arity = static_cast<std::size_t>(catalog.functions[neuron.function].arity);
    CAMBRIAN_TICK_ASSERT(arity >= 1 && arity <= gene_range::kMaxArity, "a function has inputs");
    neuron.inputs.resize(arity, InputGene{.source = {}, .weight = 0.0});
    for (InputGene& input : neuron.inputs)
        repair_input(input, scope);
}

void repair_neurons(std::vector<NeuronGene>& neurons, std::size_t limit, SourceScope scope,
                    const KindCatalog& catalog) {
    trim(neurons, limit);
    for (NeuronGene& neuron : neurons)
        repair_neuron(neuron, scope, catalog);
}

int reflect_recursion(int limit) {
    return static_cast<int>(reflect(limit, 1, gene_range::kMaxRecursion));
}

void repair_parameters(OrganGene& organ, const OrganEntry& kind) {
    for (std::size_t i = 0; i < organ.parameters.size(); ++i) {
        double& parameter = organ.parameters[i];
        parameter = i < kind.parameters.size() ? fit(parameter, kind.parameters[i]) : 0.0;
    }
}

// Keeps the first organ of each kind of which a part has only one.
void drop_doubles(std::vector<OrganGene>& organs, const KindCatalog& catalog) {
    for (std::size_t i = 0; i < organs.size(); ++i) {
        const std::uint8_t kind = organs[i].kind;
        if (!catalog.organs[kind].single) continue;
        const auto later = organs.begin() + static_cast<std::ptrdiff_t>(i) + 1;
        organs.erase(std::remove_if(later, organs.end(),
                                    [&](const OrganGene& organ) { return organ.kind == kind; }),
                     organs.end());
    }
}

void repair_organs(std::vector<OrganGene>& organs, const KindCatalog& catalog) {
    std::erase_if(organs,
                  [&](const OrganGene& organ) { return organ.kind >= catalog.organs.size(); });
    drop_doubles(organs, catalog);
    trim(organs, gene_range::kMaxOrgans);
    for (OrganGene& organ : organs) {
        repair_input(organ.input, SourceScope::kPart);
        repair_parameters(organ, catalog.organs[organ.kind]);
    }
}

// Every degree of freedom but the first has genes of its own.
void repair_degrees(NodeGene& node, const KindCatalog& catalog) {
    const int degrees = catalog.joints[node.joint].degrees_of_freedom;
    node.further.resize(static_cast<std::size_t>(std::max(degrees - 1, 0)));
    for (DegreeGene& degree : node.further) {
        fit_fields(degree, degree_fields());
        repair_input(degree.effector, SourceScope::kPart);
    }
}

// Sets what only bodies in space have to its default.
template <class Gene>
void flatten_fields(Gene& gene) {
    visit_fields<Gene>([&](const auto& field) {
        if (field.use == FieldUse::kBodyInSpace) gene.*field.value = Gene{}.*field.value;
    });
}

void flatten(Genome& genome) {
    flatten_fields(genome);
    for (NodeGene& node : genome.nodes) {
        flatten_fields(node);
        for (EdgeGene& edge : node.edges)
            flatten_fields(edge);
    }
}

void repair_node(NodeGene& node, std::size_t node_count, const KindCatalog& catalog) {
    std::erase_if(node.edges, [&](const EdgeGene& edge) { return edge.target >= node_count; });
    fit_fields(node, node_fields(catalog.dimensions));
    node.recursion_limit = reflect_recursion(node.recursion_limit);
    if (node.joint >= catalog.joints.size()) {
        node.joint =
            std::min(NodeGene{}.joint, static_cast<std::uint8_t>(catalog.joints.size() - 1));
    }
    if (node.mirror_axis > last_mirror_axis(catalog.dimensions))
        node.mirror_axis = MirrorAxis::kAlong;
    repair_degrees(node, catalog);
    if (node.effector_kind >= catalog.effectors.size()) node.effector_kind = 0;
    repair_input(node.effector, SourceScope::kPart);
    repair_organs(node.organs, catalog);
    repair_neurons(node.neurons, gene_range::kMaxNodeNeurons, SourceScope::kPart, catalog);
    trim(node.edges, gene_range::kMaxEdges);
    for (EdgeGene& edge : node.edges)
        fit_fields(edge, edge_fields(catalog.dimensions));
}

// Cutting off the end of the canonical order leaves all other nodes reachable, since every node
// but the root is reached from an earlier one.
void restore_canonical_order(Genome& genome) {
    std::vector<std::size_t> order = breadth_first(genome, 0);
    CAMBRIAN_TICK_ASSERT(!order.empty() && order.front() == 0, "the root stays the root");
    trim(order, gene_range::kMaxNodes);
    keep_nodes(genome, order);
}

}  // namespace

void repair(Genome& genome, const KindCatalog& catalog) {
    CAMBRIAN_ASSERT(!catalog.functions.empty() && !catalog.joints.empty(), "a filled catalog");
    if (genome.nodes.empty()) genome.nodes.emplace_back();
    if (genome.dimensions == 3 && catalog.dimensions == 2) flatten(genome);
    genome.dimensions = catalog.dimensions;
    for (NodeGene& node : genome.nodes)
        repair_node(node, genome.nodes.size(), catalog);
    repair_neurons(genome.brain, gene_range::kMaxBrainNeurons, SourceScope::kBrain, catalog);
    fit_fields(genome, genome_fields(catalog.dimensions));
    if (genome.reproduction >= catalog.reproductions.size()) genome.reproduction = kNoOwnMethod;
    if (!std::isfinite(genome.hue)) genome.hue = 0.0;
    genome.hue -= std::floor(genome.hue);
    if (genome.hue >= 1.0) genome.hue = 0.0;
    if (genome.name.size() > gene_range::kMaxName) genome.name.resize(gene_range::kMaxName);
    restore_canonical_order(genome);
    CAMBRIAN_TICK_ASSERT(validate(genome, catalog).empty(), "repair leaves a valid genome");
}

}  // namespace cambrian
