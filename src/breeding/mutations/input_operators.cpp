#include "breeding/gene_sites.h"
#include "breeding/mutations/operators.h"
#include "genome/gene_fields.h"
#include "genome/words.h"

#include <fmt/core.h>

namespace cambrian {
namespace {

constexpr GeneStep kEffectorStep = {.relative = 0.3, .floor = 0.3};
constexpr double kPerturbEffectorShare = 0.55;
constexpr double kNegateEffectorShare = 0.09;
constexpr double kLocalEffectorShare = 0.4;  // share of new effector sources that are local neurons
constexpr double kNegateWeightShare = 0.1;

void perturb_weight(InputGene& input, const GeneStep& step, RandomStream& stream,
                    MutationRecord& record) {
    record.place += " weight";
    record.from = in_words(input.weight);
    input.weight = perturb(input.weight, input_fields()[0].rule, step, stream);
    record.to = in_words(input.weight);
}

void negate_weight(InputGene& input, MutationRecord& record) {
    record.place += " weight";
    record.from = in_words(input.weight);
    input.weight = -input.weight;
    record.to = in_words(input.weight);
}

bool mutate_effector(Genome& genome, const MutationContext& context, RandomStream& stream,
                     MutationRecord& record) {
    const std::size_t index = stream.below(genome.nodes.size());
    NodeGene& node = genome.nodes[index];
    record.place = fmt::format("part {} effector", index);
    const double kind = stream.uniform();
    const std::size_t degree = node.further.empty() ? 0 : stream.below(node.further.size() + 1);
    InputGene& effector = effector_of(node, degree);
    if (degree > 0) record.place += fmt::format(" {}", degree + 1);
    if (kind < kPerturbEffectorShare) {
        perturb_weight(effector, kEffectorStep, stream, record);
    } else if (kind < kPerturbEffectorShare + kNegateEffectorShare) {
        negate_weight(effector, record);
    } else {
        const SourceRef source =
            random_effector_source(node, kLocalEffectorShare, pool_of(context), stream);
        replace_source(effector, source, context.catalog, record);
        node.effector_kind = random_effector_kind(context.catalog, stream);
    }
    return true;
}

bool mutate_weight(Genome& genome, const MutationContext& /*context*/, RandomStream& stream,
                   MutationRecord& record) {
    const auto sites = input_sites(genome);
    const InputSite& site = stream.pick(sites);
    record.place = site.in_words();
    if (stream.chance(kNegateWeightShare)) {
        negate_weight(site.in(genome), record);
    } else {
        perturb_weight(site.in(genome), input_fields()[0].rule.step, stream, record);
    }
    return true;
}

bool mutate_source(Genome& genome, const MutationContext& context, RandomStream& stream,
                   MutationRecord& record) {
    const auto sites = input_sites(genome);
    const InputSite& site = stream.pick(sites);
    record.place = site.in_words();
    const SourceRef source = random_source(site.list.scope, pool_of(context), stream);
    replace_source(site.in(genome), source, context.catalog, record);
    return true;
}

}  // namespace

void replace_source(InputGene& input, const SourceRef& source, const KindCatalog& catalog,
                    MutationRecord& record) {
    record.place += " source";
    record.from = in_words(input.source, catalog);
    input.source = source;
    record.to = in_words(input.source, catalog);
}

void add_input_operators(MutationRegistry& mutations) {
    mutations.add({"effector", "Effector", MutationPhase::kParameters, MutationSubject::kBrain, 9,
                   mutate_effector});
    mutations.add({"weight", "Link weight", MutationPhase::kParameters, MutationSubject::kBrain, 18,
                   mutate_weight});
    mutations.add({"source", "Link source", MutationPhase::kParameters, MutationSubject::kBrain, 9,
                   mutate_source});
}

}  // namespace cambrian
