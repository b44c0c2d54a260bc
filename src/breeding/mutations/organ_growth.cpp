#include "breeding/gene_sites.h"
#include "breeding/mutations/operators.h"
#include "genome/founders/enabled_kinds.h"

#include <fmt/core.h>

#include <algorithm>
#include <vector>

namespace cambrian {
namespace {

// Returns the enabled kinds of which the part may have one more.
std::vector<std::uint8_t> kinds_for(const NodeGene& node, const MutationContext& context) {
    std::vector<std::uint8_t> kinds = enabled_organs(context.founders, context.catalog);
    std::erase_if(kinds, [&](std::uint8_t kind) {
        return context.catalog.organs[kind].single &&
               std::any_of(node.organs.begin(), node.organs.end(),
                           [&](const OrganGene& organ) { return organ.kind == kind; });
    });
    return kinds;
}

bool add_organ(Genome& genome, const MutationContext& context, RandomStream& stream,
               MutationRecord& record) {
    auto nodes = nodes_with_room_for_organs(genome);
    std::erase_if(nodes,
                  [&](std::size_t node) { return kinds_for(genome.nodes[node], context).empty(); });
    if (nodes.empty()) return false;
    const std::size_t index = stream.pick(nodes);
    NodeGene& node = genome.nodes[index];
    const auto kinds = kinds_for(node, context);
    const std::uint8_t kind = stream.pick(kinds);
    node.organs.push_back(random_organ(kind, node, pool_of(context), stream));
    record.place = fmt::format("part {}", index);
    record.to = "new organ " + context.catalog.organs[kind].id;
    return true;
}

}  // namespace

bool organs_enabled(const MutationContext& context) {
    return !enabled_organs(context.founders, context.catalog).empty();
}

void add_organ_growth(MutationRegistry& mutations) {
    mutations.add({"add-organ", "New organ", MutationPhase::kGrowth, MutationSubject::kBrain, 4,
                   add_organ, organs_enabled, true});
}

}  // namespace cambrian
