#include "breeding/gene_sites.h"
#include "breeding/mutations/operators.h"

namespace cambrian {
namespace {

// Rewrites the references within one list of neurons for the loss of one of them.
class Removal {
public:
    Removal(const NeuronSite& site, const std::vector<NeuronGene>& list)
        : scope_(site.list.scope), removed_(site.neuron), count_(list.size()) {
        heir_ = moved(list[removed_].inputs[0].source);
    }

    // Links to the removed neuron hear what it heard first; neurons above it have moved down.
    void rewrite(SourceRef& source) const {
        source = names_removed(source) ? heir_ : moved(source);
    }

private:
    bool names_removed(const SourceRef& source) const {
        return source.kind == own_neuron_kind(scope_) && source.index % count_ == removed_;
    }
    // A neuron that heard only itself leaves a constant behind.
    SourceRef moved(const SourceRef& source) const {
        if (source.kind != own_neuron_kind(scope_)) return source;
        if (names_removed(source)) return {};
        const std::size_t index = source.index % count_;
        return own_neuron(scope_, index > removed_ ? index - 1 : index);
    }

    SourceScope scope_;
    std::size_t removed_;
    std::size_t count_;
    SourceRef heir_;
};

bool remove_neuron(Genome& genome, const MutationContext& context, RandomStream& stream,
                   MutationRecord& record) {
    const auto sites = neuron_sites(genome);
    if (sites.empty()) return false;
    const NeuronSite& site = stream.pick(sites);
    std::vector<NeuronGene>& list = site.list.in(genome);
    record.place = site.in_words();
    record.from = context.catalog.functions[list[site.neuron].function].id;
    record.to = "removed";
    const Removal removal(site, list);
    list.erase(list.begin() + static_cast<std::ptrdiff_t>(site.neuron));
    for (NeuronGene& neuron : list) {
        for (InputGene& input : neuron.inputs)
            removal.rewrite(input.source);
    }
    if (site.list.scope == SourceScope::kPart) {
        removal.rewrite(genome.nodes[site.list.node].effector.source);
    }
    return true;
}

}  // namespace

void add_removal_operators(MutationRegistry& mutations) {
    mutations.add(
        {"remove-neuron", "Removed neuron", MutationPhase::kConnections, 4, remove_neuron});
}

}  // namespace cambrian
