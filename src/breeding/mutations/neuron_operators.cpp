#include "breeding/gene_sites.h"
#include "breeding/mutations/operators.h"
#include "genome/founders/enabled_kinds.h"

namespace cambrian {
namespace {

void set_function(NeuronGene& neuron, std::uint8_t function, SourceScope scope,
                  const MutationContext& context, RandomStream& stream) {
    const auto arity = static_cast<std::size_t>(context.catalog.functions[function].arity);
    neuron.function = function;
    if (neuron.inputs.size() > arity) neuron.inputs.resize(arity);
    while (neuron.inputs.size() < arity) {
        neuron.inputs.push_back(
            random_function_input(function, neuron.inputs.size(), scope, pool_of(context), stream));
    }
}

bool mutate_function(Genome& genome, const MutationContext& context, RandomStream& stream,
                     MutationRecord& record) {
    const auto sites = neuron_sites(genome);
    if (sites.empty()) return false;
    const NeuronSite& site = stream.pick(sites);
    NeuronGene& neuron = site.in(genome);
    const auto enabled = enabled_functions(context.founders, context.catalog);
    record.place = site.in_words() + " function";
    record.from = context.catalog.functions[neuron.function].id;
    set_function(neuron, stream.pick(enabled), site.list.scope, context, stream);
    record.to = context.catalog.functions[neuron.function].id;
    return true;
}

}  // namespace

void add_neuron_operators(MutationRegistry& mutations) {
    mutations.add({"function", "Neuron function", MutationPhase::kParameters,
                   MutationSubject::kBrain, 5, mutate_function});
}

}  // namespace cambrian
