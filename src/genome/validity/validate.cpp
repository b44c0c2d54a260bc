#include "genome/gene_fields.h"
#include "genome/genome.h"
#include "genome/genome_graph.h"
#include "genome/source_rules.h"
#include "genome/words.h"

#include <fmt/core.h>

#include <algorithm>
#include <string_view>

namespace cambrian {
namespace {

// Collects the faults of a genome, each with its place.
class Validator {
public:
    Validator(const Genome& genome, const KindCatalog& catalog)
        : genome_(genome), catalog_(catalog) {}

    std::vector<std::string> run() {
        check_size("/nodes", genome_.nodes.size(), 1, gene_range::kMaxNodes);
        check_size("/brain", genome_.brain.size(), 0, gene_range::kMaxBrainNeurons);
        if (genome_.dimensions != catalog_.dimensions)
            complain("/dimensions",
                     fmt::format("{}, expected {}", genome_.dimensions, catalog_.dimensions));
        check_fields("", genome_, genome_fields(catalog_.dimensions));
        if (genome_.reproduction >= catalog_.reproductions.size()) {
            complain("/reproduction", "is not a known method");
        }
        check_neurons("/brain", genome_.brain, SourceScope::kBrain);
        for (std::size_t i = 0; i < genome_.nodes.size(); ++i)
            check_node(fmt::format("/nodes/{}", i), genome_.nodes[i]);
        if (!genome_.nodes.empty()) check_order();
        return std::move(complaints_);
    }

private:
    void complain(const std::string& place, const std::string& what) {
        complaints_.push_back(fmt::format("{}: {}", place, what));
    }

    void check_size(const std::string& place, std::size_t size, std::size_t low, std::size_t high) {
        if (size >= low && size <= high) return;
        complain(place, fmt::format("{} entries, allowed are {} to {}", size, low, high));
    }

    template <class Gene>
    void check_fields(const std::string& place, const Gene& gene,
                      std::span<const GeneField<Gene>> fields) {
        for (const GeneField<Gene>& field : fields)
            check_number(place, gene.*field.value, field.rule);
    }

    void check_number(const std::string& place, double x, const FieldRule& rule) {
        if (in_range(x, rule)) return;
        complain(fmt::format("{}/{}", place, rule.key),
                 fmt::format("{} is outside [{}, {}{}{}", in_words(x), in_words(rule.low),
                             in_words(rule.high), rule.wraps ? ")" : "]",
                             rule.whole ? " or not a whole number" : ""));
    }

    void check_input(const std::string& place, const InputGene& input, SourceScope scope) {
        check_fields(place, input, input_fields());
        if (!is_known(input.source.kind)) {
            complain(place + "/from/kind", "is not a known kind of source");
        } else if (!is_allowed(input.source.kind, scope)) {
            complain(place + "/from/kind", scope == SourceScope::kPart
                                               ? "is only for central neurons"
                                               : "is only for part neurons");
        } else if (canonical(input.source, scope) != input.source) {
            complain(place + "/from", "a number is above 15 or not used by this kind of source");
        }
    }

    void check_neurons(const std::string& place, const std::vector<NeuronGene>& neurons,
                       SourceScope scope) {
        for (std::size_t i = 0; i < neurons.size(); ++i)
            check_neuron(fmt::format("{}/{}", place, i), neurons[i], scope);
    }

    void check_neuron(const std::string& place, const NeuronGene& neuron, SourceScope scope) {
        if (neuron.function >= catalog_.functions.size()) {
            complain(place + "/fn", "is not a known function");
            return;
        }
        const FunctionEntry& function = catalog_.functions[neuron.function];
        if (neuron.inputs.size() != static_cast<std::size_t>(function.arity)) {
            complain(place + "/in", fmt::format("function \"{}\" needs {} inputs, found {}",
                                                function.id, function.arity, neuron.inputs.size()));
        }
        for (std::size_t i = 0; i < neuron.inputs.size(); ++i)
            check_input(fmt::format("{}/in/{}", place, i), neuron.inputs[i], scope);
    }

    void check_node(const std::string& place, const NodeGene& node) {
        check_fields(place, node, node_fields(catalog_.dimensions));
        if (node.joint >= catalog_.joints.size())
            complain(place + "/joint", "is not a known joint");
        if (node.recursion_limit < 1 || node.recursion_limit > gene_range::kMaxRecursion) {
            complain(place + "/recursionLimit",
                     fmt::format("{} is outside [1, {}]", node.recursion_limit,
                                 gene_range::kMaxRecursion));
        }
        if (node.mirror_axis > last_mirror_axis(catalog_.dimensions))
            complain(place + "/mirrorAxis", "is unknown");
        check_degrees(place, node);
        if (node.effector_kind >= catalog_.effectors.size())
            complain(place + "/effector/kind", "is not a known effector");
        check_input(place + "/effector", node.effector, SourceScope::kPart);
        check_size(place + "/organs", node.organs.size(), 0, gene_range::kMaxOrgans);
        for (std::size_t i = 0; i < node.organs.size(); ++i) {
            check_organ(fmt::format("{}/organs/{}", place, i), node.organs[i]);
            check_double(fmt::format("{}/organs/{}/kind", place, i), node.organs, i);
        }
        check_size(place + "/neurons", node.neurons.size(), 0, gene_range::kMaxNodeNeurons);
        check_neurons(place + "/neurons", node.neurons, SourceScope::kPart);
        check_size(place + "/edges", node.edges.size(), 0, gene_range::kMaxEdges);
        for (std::size_t i = 0; i < node.edges.size(); ++i)
            check_edge(fmt::format("{}/edges/{}", place, i), node.edges[i]);
    }

    void check_degrees(const std::string& place, const NodeGene& node) {
        if (node.joint >= catalog_.joints.size()) return;
        const int degrees = std::max(catalog_.joints[node.joint].degrees_of_freedom, 1);
        const auto needed = static_cast<std::size_t>(degrees - 1);
        check_size(place + "/further", node.further.size(), needed, needed);
        for (std::size_t i = 0; i < node.further.size(); ++i) {
            const std::string degree = fmt::format("{}/further/{}", place, i);
            check_fields(degree, node.further[i], degree_fields());
            check_input(degree + "/effector", node.further[i].effector, SourceScope::kPart);
        }
    }

    void check_organ(const std::string& place, const OrganGene& organ) {
        check_input(place, organ.input, SourceScope::kPart);
        if (organ.kind >= catalog_.organs.size()) {
            complain(place + "/kind", "is not a known organ");
            return;
        }
        const std::vector<FieldRule>& rules = catalog_.organs[organ.kind].parameters;
        for (std::size_t i = 0; i < organ.parameters.size(); ++i) {
            if (i < rules.size()) {
                check_number(place, organ.parameters[i], rules[i]);
            } else if (organ.parameters[i] != 0.0) {
                complain(place, "has a parameter that its kind does not use");
            }
        }
    }

    void check_double(const std::string& place, const std::vector<OrganGene>& organs,
                      std::size_t index) {
        const std::uint8_t kind = organs[index].kind;
        if (kind >= catalog_.organs.size() || !catalog_.organs[kind].single) return;
        for (std::size_t i = 0; i < index; ++i) {
            if (organs[i].kind != kind) continue;
            complain(place, fmt::format("is a second {}, but a part has at most one",
                                        catalog_.organs[kind].id));
            return;
        }
    }

    void check_edge(const std::string& place, const EdgeGene& edge) {
        check_fields(place, edge, edge_fields(catalog_.dimensions));
        if (edge.target >= genome_.nodes.size()) {
            complain(place + "/target",
                     fmt::format("{}, but there are {} nodes", edge.target, genome_.nodes.size()));
        }
    }

    void check_order() {
        const std::vector<std::size_t> order = breadth_first(genome_, 0);
        if (order.size() < genome_.nodes.size()) {
            complain("/nodes", fmt::format("{} cannot be reached from the root",
                                           genome_.nodes.size() - order.size()));
        }
        for (std::size_t i = 0; i < order.size(); ++i) {
            if (order[i] == i) continue;
            complain("/nodes", "are not in breadth-first order from the root");
            return;
        }
    }

    const Genome& genome_;
    const KindCatalog& catalog_;
    std::vector<std::string> complaints_;
};

}  // namespace

std::vector<std::string> validate(const Genome& genome, const KindCatalog& catalog) {
    return Validator(genome, catalog).run();
}

}  // namespace cambrian
