#include "breeding/gene_sites.h"
#include "breeding/mutations/operators.h"
#include "genome/founders/enabled_kinds.h"
#include "genome/words.h"

#include <fmt/core.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>

namespace cambrian {
namespace {

constexpr double kMaxReflexWeight = 1.0;
constexpr std::string_view kSum = "sum";

// Returns the function whose neurons add their inputs, unless the settings exclude it.
std::optional<std::uint8_t> enabled_sum(const MutationContext& context) {
    for (const std::uint8_t function : enabled_functions(context.founders, context.catalog)) {
        if (context.catalog.functions[function].id == kSum) return function;
    }
    return std::nullopt;
}

bool may_read(SourceKind kind, const MutationContext& context) {
    return is_enabled(kind, SourceScope::kPart, context.founders, context.catalog);
}

// The joint keeps what moves it: the sum's first input is the effector's old source.
bool add_reflex(Genome& genome, const MutationContext& context, RandomStream& stream,
                MutationRecord& record) {
    const auto nodes = nodes_with_room_for_neurons(genome);
    const auto sum = enabled_sum(context);
    if (nodes.empty() || !sum || !may_read(SourceKind::kLocalNeuron, context) ||
        !may_read(SourceKind::kLocalSensor, context))
        return false;
    const std::size_t index = stream.pick(nodes);
    NodeGene& node = genome.nodes[index];
    InputGene& effector =
        effector_of(node, node.further.empty() ? 0 : stream.below(node.further.size() + 1));
    const auto channels = enabled_channels(context.founders, context.catalog);
    const std::uint8_t channel = stream.pick(channels);
    const double weight = stream.uniform(-kMaxReflexWeight, kMaxReflexWeight);
    record.place = fmt::format("part {} effector", index);
    record.from = in_words(effector.source, context.catalog);
    record.to = "sum with sensor " + context.catalog.channels[channel].id;
    NeuronGene neuron{*sum,
                      {{effector.source, 1.0}, {{SourceKind::kLocalSensor, channel}, weight}}};
    neuron.inputs.resize(static_cast<std::size_t>(context.catalog.functions[*sum].arity),
                         {{}, 0.0});
    node.neurons.push_back(std::move(neuron));
    effector.source = own_neuron(SourceScope::kPart, node.neurons.size() - 1);
    return true;
}

}  // namespace

void add_reflex_growth(MutationRegistry& mutations) {
    mutations.add({.id = "add-reflex",
                   .label = "New reflex",
                   .phase = MutationPhase::kGrowth,
                   .subject = MutationSubject::kBrain,
                   .default_weight = 0.0,
                   .apply = add_reflex,
                   .later = true});
}

}  // namespace cambrian
