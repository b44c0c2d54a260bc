#include "breeding/gene_sites.h"
#include "breeding/mutations/operators.h"
#include "genome/gene_fields.h"
#include "genome/words.h"

#include <fmt/core.h>

namespace cambrian {
namespace {

constexpr double kReflectToggleShare =
    0.6;  // share of flag changes; the others toggle terminal-only

bool mutate_edge_scalar(Genome& genome, const MutationContext& context, RandomStream& stream,
                        MutationRecord& record) {
    const auto sites = edge_sites(genome);
    if (sites.empty()) return false;
    const EdgeSite& site = stream.pick(sites);
    const auto fields = edge_fields(context.catalog.dimensions);
    const GeneField<EdgeGene>& field = stream.pick(fields);
    double& x = site.in(genome).*field.value;
    record.place = fmt::format("{} {}", site.in_words(), field.rule.name);
    record.from = in_words(x);
    x = perturb(x, field.rule, field.rule.step, stream);
    record.to = in_words(x);
    return true;
}

bool mutate_edge_flag(Genome& genome, const MutationContext& context, RandomStream& stream,
                      MutationRecord& record) {
    const auto sites = edge_sites(genome);
    if (sites.empty()) return false;
    const EdgeSite& site = stream.pick(sites);
    const bool reflects = stream.chance(kReflectToggleShare);
    const bool deep = reflects && context.catalog.dimensions == 3 && stream.chance(0.5);
    EdgeGene& edge = site.in(genome);
    bool& flag = deep ? edge.reflect_depth : reflects ? edge.reflect : edge.terminal_only;
    record.place = site.in_words() + (deep       ? " reflect depth"
                                      : reflects ? " reflect"
                                                 : " terminal only");
    record.from = flag ? "on" : "off";
    flag = !flag;
    record.to = flag ? "on" : "off";
    return true;
}

bool retarget(Genome& genome, const MutationContext& /*context*/, RandomStream& stream,
              MutationRecord& record) {
    const auto sites = edge_sites(genome);
    if (sites.empty() || genome.nodes.size() < 2) return false;
    const EdgeSite& site = stream.pick(sites);
    EdgeGene& edge = site.in(genome);
    const std::size_t step = 1 + stream.below(genome.nodes.size() - 1);
    record.place = site.in_words() + " target";
    record.from = fmt::format("part {}", edge.target);
    edge.target = static_cast<std::uint8_t>((edge.target + step) % genome.nodes.size());
    record.to = fmt::format("part {}", edge.target);
    return true;
}

}  // namespace

void add_edge_operators(MutationRegistry& mutations) {
    mutations.add({"edge-scalar", "Attachment place", MutationPhase::kConnections,
                   MutationSubject::kBody, 14, mutate_edge_scalar});
    mutations.add({"edge-flag", "Attachment mirroring", MutationPhase::kConnections,
                   MutationSubject::kBody, 3, mutate_edge_flag});
    mutations.add({"retarget", "Attachment target", MutationPhase::kConnections,
                   MutationSubject::kBody, 3, retarget});
}

}  // namespace cambrian
