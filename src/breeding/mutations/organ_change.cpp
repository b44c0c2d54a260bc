#include "breeding/gene_sites.h"
#include "breeding/mutations/operators.h"
#include "genome/words.h"

#include <fmt/core.h>

namespace cambrian {
namespace {

constexpr double kParameterShare = 0.5;  // of the changes of an organ with parameters
constexpr double kOwnNeuronShare = 0.4;  // of the new sources

// Changes a parameter or the source of an organ; other operators change its weight.
bool mutate_organ(Genome& genome, const MutationContext& context, RandomStream& stream,
                  MutationRecord& record) {
    const auto sites = organ_sites(genome);
    if (sites.empty()) return false;
    const OrganGeneSite& site = stream.pick(sites);
    OrganGene& organ = site.in(genome);
    const std::vector<FieldRule>& rules = context.catalog.organs[organ.kind].parameters;
    if (!rules.empty() && stream.chance(kParameterShare)) {
        const std::size_t index = stream.below(rules.size());
        double& parameter = organ.parameters[index];
        record.place = fmt::format("{} {}", site.in_words(), rules[index].name);
        record.from = in_words(parameter);
        parameter = perturb(parameter, rules[index], rules[index].step, stream);
        record.to = in_words(parameter);
        return true;
    }
    record.place = site.in_words();
    const SourceRef source =
        random_effector_source(genome.nodes[site.node], kOwnNeuronShare, pool_of(context), stream);
    replace_source(organ.input, source, context.catalog, record);
    return true;
}

}  // namespace

void add_organ_change(MutationRegistry& mutations) {
    mutations.add({"organ", "Organ", MutationPhase::kParameters, MutationSubject::kBrain, 8,
                   mutate_organ, organs_enabled, true});
}

}  // namespace cambrian
