#include "breeding/gene_sites.h"
#include "breeding/mutations/operators.h"

namespace cambrian {
namespace {

bool remove_organ(Genome& genome, const MutationContext& context, RandomStream& stream,
                  MutationRecord& record) {
    const auto sites = organ_sites(genome);
    if (sites.empty()) return false;
    const OrganGeneSite& site = stream.pick(sites);
    record.place = site.in_words();
    record.from = context.catalog.organs[site.in(genome).kind].id;
    record.to = "removed";
    std::vector<OrganGene>& organs = genome.nodes[site.node].organs;
    organs.erase(organs.begin() + static_cast<std::ptrdiff_t>(site.organ));
    return true;
}

}  // namespace

void add_organ_removal(MutationRegistry& mutations) {
    mutations.add({"remove-organ", "Removed organ", MutationPhase::kConnections,
                   MutationSubject::kBrain, 2, remove_organ, organs_enabled, true});
}

}  // namespace cambrian
