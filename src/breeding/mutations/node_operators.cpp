#include "breeding/mutations/operators.h"
#include "genome/founders/enabled_kinds.h"
#include "genome/gene_fields.h"
#include "genome/words.h"
#include "math/reflect.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>

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

bool mutate_node_scalar(Genome& genome, const MutationContext& context, RandomStream& stream,
                        MutationRecord& record) {
    const std::size_t index = stream.below(genome.nodes.size());
    NodeGene& node = genome.nodes[index];
    const auto fields = node_fields(context.catalog.dimensions);
    const auto further = degree_fields();
    const std::size_t drawn = stream.below(fields.size() + node.further.size() * further.size());
    if (drawn < fields.size()) {
        perturb_field(node, fields[drawn], part_in_words(index), stream, record);
        return true;
    }
    const std::size_t degree = (drawn - fields.size()) / further.size();
    perturb_field(node.further[degree], further[(drawn - fields.size()) % further.size()],
                  fmt::format("{}degree {} ", part_in_words(index), degree + 2), stream, record);
    return true;
}

bool mutate_root(Genome& genome, const MutationContext& context, RandomStream& stream,
                 MutationRecord& record) {
    const auto fields = genome_fields(context.catalog.dimensions);
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

// Names the axes in their order.
constexpr std::array<const char*, 3> kMirrorAxisWords = {"along", "across", "depth"};

void change_mirror_axis(NodeGene& node, int dimensions, RandomStream& stream,
                        MutationRecord& record) {
    const int axes = dimensions;  // the plane has two to choose from, space three
    const int before = static_cast<int>(node.mirror_axis);
    const int after = (before + (axes == 2 ? 1 : stream.between(1, axes - 1))) % axes;
    node.mirror_axis = static_cast<MirrorAxis>(after);
    record.place += "mirror axis";
    record.from = kMirrorAxisWords[static_cast<std::size_t>(before)];
    record.to = kMirrorAxisWords[static_cast<std::size_t>(after)];
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
            change_mirror_axis(node, context.catalog.dimensions, stream, record);
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
