#include "breeding/mutations/operators.h"
#include "genome/founders/enabled_kinds.h"
#include "genome/gene_fields.h"
#include "genome/words.h"
#include "math/reflect.h"

#include <fmt/core.h>

#include <algorithm>

namespace cambrian {
namespace {

// Share of discrete changes that change the breeding method, if that is a gene.
constexpr double kReproductionShare = 0.1;

template <class Gene>
void perturb_field(Gene& gene, const GeneField<Gene>& field, const std::string& place,
                   RandomStream& stream, MutationRecord& record) {
    double& x = gene.*field.value;
    record.place = place + field.rule.name;
    record.from = in_words(x);
    x = perturb(x, field.rule, field.rule.step, stream);
    record.to = in_words(x);
}

std::string part_in_words(std::size_t node) {
    return fmt::format("part {} ", node);
}

bool mutate_node_scalar(Genome& genome, const MutationContext& /*context*/, RandomStream& stream,
                        MutationRecord& record) {
    const std::size_t node = stream.below(genome.nodes.size());
    const auto fields = node_fields();
    perturb_field(genome.nodes[node], stream.pick(fields), part_in_words(node), stream, record);
    return true;
}

bool mutate_root(Genome& genome, const MutationContext& /*context*/, RandomStream& stream,
                 MutationRecord& record) {
    const auto fields = genome_fields();
    perturb_field(genome, stream.pick(fields), "", stream, record);
    return true;
}

void next_joint(NodeGene& node, const MutationContext& context, MutationRecord& record) {
    const auto enabled = enabled_joints(context.founders, context.catalog);
    const auto next = std::upper_bound(enabled.begin(), enabled.end(), node.joint);
    record.place += "joint";
    record.from = context.catalog.joints[node.joint].id;
    node.joint = next == enabled.end() ? enabled.front() : *next;
    record.to = context.catalog.joints[node.joint].id;
}

void step_recursion(NodeGene& node, RandomStream& stream, MutationRecord& record) {
    const int stepped = node.recursion_limit + (stream.chance(0.5) ? 1 : -1);
    record.place += "recursion limit";
    record.from = std::to_string(node.recursion_limit);
    node.recursion_limit = static_cast<int>(reflect(stepped, 1, gene_range::kMaxRecursion));
    record.to = std::to_string(node.recursion_limit);
}

void toggle_symmetry(NodeGene& node, MutationRecord& record) {
    node.symmetric = !node.symmetric;
    record.place += "symmetry";
    record.from = node.symmetric ? "off" : "on";
    record.to = node.symmetric ? "on" : "off";
}

void toggle_mirror_axis(NodeGene& node, MutationRecord& record) {
    const bool was_along = node.mirror_axis == MirrorAxis::kAlong;
    node.mirror_axis = was_along ? MirrorAxis::kAcross : MirrorAxis::kAlong;
    record.place += "mirror axis";
    record.from = was_along ? "along" : "across";
    record.to = was_along ? "across" : "along";
}

bool change_reproduction(Genome& genome, const std::vector<std::string>& methods,
                         RandomStream& stream, MutationRecord& record) {
    const int count = static_cast<int>(methods.size());
    if (count < 2) return false;
    record.place = "reproduction";
    record.from = methods[genome.reproduction];
    const int next = genome.reproduction + stream.between(1, count - 1);
    genome.reproduction = static_cast<std::uint8_t>(next % count);
    record.to = methods[genome.reproduction];
    return true;
}

bool mutate_node_discrete(Genome& genome, const MutationContext& context, RandomStream& stream,
                          MutationRecord& record) {
    if (context.mutate_reproduction && stream.chance(kReproductionShare)) {
        return change_reproduction(genome, context.catalog.reproductions, stream, record);
    }
    const std::size_t index = stream.below(genome.nodes.size());
    NodeGene& node = genome.nodes[index];
    record.place = part_in_words(index);
    switch (stream.below(4)) {
        case 0:
            next_joint(node, context, record);
            break;
        case 1:
            step_recursion(node, stream, record);
            break;
        case 2:
            toggle_symmetry(node, record);
            break;
        default:
            toggle_mirror_axis(node, record);
            break;
    }
    return true;
}

}  // namespace

void add_node_operators(MutationRegistry& mutations) {
    mutations.add({"node-scalar", "Part size or limits", MutationPhase::kParameters,
                   MutationSubject::kBody, 14, mutate_node_scalar});
    mutations.add({"node-discrete", "Part joint or symmetry", MutationPhase::kParameters,
                   MutationSubject::kBody, 6, mutate_node_discrete});
    mutations.add(
        {"root", "Root angle", MutationPhase::kParameters, MutationSubject::kBody, 2, mutate_root});
}

}  // namespace cambrian
