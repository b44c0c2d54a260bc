#include "breeding/disconnected_neurons.h"

#include "breeding/gene_sites.h"
#include "core/assert.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace cambrian {
namespace {

class Collection {
public:
    explicit Collection(Genome& genome) : genome_(genome) {
        for (std::size_t node = 0; node < genome.nodes.size(); ++node)
            lists_.push_back({SourceScope::kPart, node});
        lists_.push_back({SourceScope::kBrain, 0});
        for (const NeuronListSite& list : lists_)
            heard_.emplace_back(list.in(genome).size(), false);
    }

    void run() {
        for (const Reading& reading : readings_of_parts())
            mark_heard(reading.reader, *reading.source);
        for (std::size_t list = 0; list < lists_.size(); ++list) {
            for (std::size_t i = heard_[list].size(); i > 0; --i) {
                if (!heard_[list][i - 1]) try_remove(list, i - 1);
            }
        }
    }

private:
    // A reference and the list of neurons that its reader belongs to.
    struct Reading {
        std::size_t reader;
        SourceRef* source;
    };

    std::vector<NeuronGene>& neurons(std::size_t list) const { return lists_[list].in(genome_); }

    bool has_edge(std::size_t from, std::size_t to) const {
        const std::vector<EdgeGene>& edges = genome_.nodes[from].edges;
        return std::any_of(edges.begin(), edges.end(),
                           [&](const EdgeGene& edge) { return edge.target == to; });
    }

    bool may_address(std::size_t reader, const SourceRef& source, std::size_t list) const {
        const bool is_brain = list + 1 == lists_.size();
        switch (source.kind) {
            case SourceKind::kLocalNeuron:
                return list == reader;
            case SourceKind::kParentNeuron:
                return !is_brain && has_edge(list, reader);
            case SourceKind::kChildNeuron:
                return !is_brain && has_edge(reader, list);
            case SourceKind::kBrainNeuron:
                return is_brain;
            case SourceKind::kPartNeuron:
                return list == source.node % genome_.nodes.size();
            default:
                return false;
        }
    }

    // Returns the non-empty lists of neurons that a reference may address in some body.
    std::vector<std::size_t> addressed(std::size_t reader, const SourceRef& source) const {
        std::vector<std::size_t> lists;
        for (std::size_t list = 0; list < lists_.size(); ++list) {
            if (!neurons(list).empty() && may_address(reader, source, list)) lists.push_back(list);
        }
        return lists;
    }

    void mark_heard(std::size_t reader, const SourceRef& source) {
        for (const std::size_t list : addressed(reader, source)) {
            const std::size_t neuron = source.index % neurons(list).size();
            if (heard_[list][neuron]) continue;
            heard_[list][neuron] = true;
            for (const InputGene& input : neurons(list)[neuron].inputs)
                mark_heard(list, input.source);
        }
    }

    // Returns the references of effectors and organs.
    std::vector<Reading> readings_of_parts() const {
        std::vector<Reading> all;
        for (std::size_t node = 0; node < genome_.nodes.size(); ++node) {
            all.push_back({node, &genome_.nodes[node].effector.source});
            for (DegreeGene& degree : genome_.nodes[node].further)
                all.push_back({node, &degree.effector.source});
            for (OrganGene& organ : genome_.nodes[node].organs)
                all.push_back({node, &organ.input.source});
        }
        return all;
    }

    // Returns all references whose meaning must not change.
    std::vector<Reading> readings() const {
        std::vector<Reading> all = readings_of_parts();
        for (std::size_t list = 0; list < lists_.size(); ++list) {
            for (std::size_t i = 0; i < neurons(list).size(); ++i) {
                if (!heard_[list][i]) continue;
                for (InputGene& input : neurons(list)[i].inputs)
                    all.push_back({list, &input.source});
            }
        }
        return all;
    }

    // Returns the smallest index that addresses the same neurons after one is removed.
    std::optional<std::uint8_t> renumbered(const Reading& reading, std::size_t from_list,
                                           std::size_t removed) const {
        const std::vector<std::size_t> lists = addressed(reading.reader, *reading.source);
        const auto names_same = [&](std::size_t number) {
            return std::all_of(lists.begin(), lists.end(), [&](std::size_t list) {
                const std::size_t size = neurons(list).size();
                const std::size_t old_neuron = reading.source->index % size;
                if (list != from_list) return number % size == old_neuron;
                return number % (size - 1) == old_neuron - (old_neuron > removed ? 1 : 0);
            });
        };
        for (std::uint8_t number = 0; number <= gene_range::kMaxReference; ++number) {
            if (names_same(number)) return number;
        }
        return std::nullopt;
    }

    void try_remove(std::size_t list, std::size_t neuron) {
        std::vector<std::pair<SourceRef*, std::uint8_t>> changes;
        for (const Reading& reading : readings()) {
            if (!may_address(reading.reader, *reading.source, list)) continue;
            const auto number = renumbered(reading, list, neuron);
            if (!number) return;
            changes.emplace_back(reading.source, *number);
        }
        for (const auto& [source, number] : changes)
            source->index = number;
        CAMBRIAN_TICK_ASSERT(neuron < neurons(list).size() && !heard_[list][neuron],
                             "a neuron that nobody hears");
        const auto place = static_cast<std::ptrdiff_t>(neuron);
        neurons(list).erase(neurons(list).begin() + place);
        heard_[list].erase(heard_[list].begin() + place);
    }

    Genome& genome_;
    std::vector<NeuronListSite> lists_;     // one per node, then the brain's
    std::vector<std::vector<bool>> heard_;  // whether each neuron is read, by list
};

}  // namespace

void remove_disconnected_neurons(Genome& genome) {
    Collection(genome).run();
}

}  // namespace cambrian
