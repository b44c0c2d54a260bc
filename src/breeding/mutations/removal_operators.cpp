#include "breeding/gene_sites.h"
#include "breeding/mutations/operators.h"
#include "core/assert.h"
#include "genome/founders/enabled_kinds.h"

namespace cambrian {
namespace {

// Rewrites the references in one list of neurons when one of the neurons is removed.
class Removal {
public:
    // `substitute` replaces the input of a neuron that read only itself.
    Removal(const NeuronSite& site, const std::vector<NeuronGene>& list,
            const SourceRef& substitute)
        : scope_(site.list.scope),
          removed_(site.neuron),
          count_(list.size()),
          substitute_(substitute) {
        heir_ = moved(list[removed_].inputs[0].source);
    }

    // Links to the removed neuron read its first input; neurons above it have moved down.
    void rewrite(SourceRef& source) const {
        source = names_removed(source) ? heir_ : moved(source);
    }

private:
    bool names_removed(const SourceRef& source) const {
        return source.kind == own_neuron_kind(scope_) && source.index % count_ == removed_;
    }
    SourceRef moved(const SourceRef& source) const {
        if (source.kind != own_neuron_kind(scope_)) return source;
        if (names_removed(source)) return substitute_;
        CAMBRIAN_TICK_ASSERT(count_ > 0 && removed_ < count_, "one of the neurons");
        const std::size_t index = source.index % count_;
        return own_neuron(scope_, index > removed_ ? index - 1 : index);
    }

    SourceScope scope_;
    std::size_t removed_;
    std::size_t count_;
    SourceRef substitute_;
    SourceRef heir_;
};

// Returns a constant if constants are allowed, otherwise a random source.
SourceRef substitute_source(SourceScope scope, const MutationContext& context,
                            RandomStream& stream) {
    if (is_enabled(SourceKind::kConstant, scope, context.founders, context.catalog)) return {};
    return random_source(scope, pool_of(context), stream);
}

bool remove_neuron(Genome& genome, const MutationContext& context, RandomStream& stream,
                   MutationRecord& record) {
    const auto sites = neuron_sites(genome);
    if (sites.empty()) return false;
    const NeuronSite& site = stream.pick(sites);
    std::vector<NeuronGene>& list = site.list.in(genome);
    record.place = site.in_words();
    record.from = context.catalog.functions[list[site.neuron].function].id;
    record.to = "removed";
    const Removal removal(site, list, substitute_source(site.list.scope, context, stream));
    list.erase(list.begin() + static_cast<std::ptrdiff_t>(site.neuron));
    for (NeuronGene& neuron : list) {
        for (InputGene& input : neuron.inputs)
            removal.rewrite(input.source);
    }
    if (site.list.scope == SourceScope::kPart) {
        NodeGene& node = genome.nodes[site.list.node];
        removal.rewrite(node.effector.source);
        for (DegreeGene& degree : node.further)
            removal.rewrite(degree.effector.source);
        for (OrganGene& organ : node.organs)
            removal.rewrite(organ.input.source);
    }
    return true;
}

}  // namespace

void add_removal_operators(MutationRegistry& mutations) {
    mutations.add({"remove-neuron", "Removed neuron", MutationPhase::kConnections,
                   MutationSubject::kBrain, 4, remove_neuron});
}

}  // namespace cambrian
