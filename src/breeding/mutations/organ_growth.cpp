#include "breeding/gene_sites.h"
#include "breeding/mutations/operators.h"
#include "genome/founders/enabled_kinds.h"

#include <fmt/core.h>

namespace cambrian {
namespace {

bool add_organ(Genome& genome, const MutationContext& context, RandomStream& stream,
               MutationRecord& record) {
    const auto kinds = enabled_organs(context.founders, context.catalog);
    const auto nodes = nodes_with_room_for_organs(genome);
    if (kinds.empty() || nodes.empty()) return false;
    const std::size_t index = stream.pick(nodes);
    NodeGene& node = genome.nodes[index];
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
