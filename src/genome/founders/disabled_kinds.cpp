#include "genome/founders/disabled_kinds.h"

#include "genome/founders/enabled_kinds.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

namespace cambrian {
namespace {

bool contains(const std::vector<std::uint8_t>& enabled, std::uint8_t index) {
    return std::find(enabled.begin(), enabled.end(), index) != enabled.end();
}

// Visits a genome and lists the kinds that are not enabled.
class Search {
public:
    Search(const FounderSettings& settings, const KindCatalog& catalog)
        : catalog_(catalog),
          functions_(enabled_functions(settings, catalog)),
          joints_(enabled_joints(settings, catalog)),
          organs_(enabled_organs(settings, catalog)),
          channels_(enabled_channels(settings, catalog)) {}

    void look_at(const NodeGene& node, const std::string& place) {
        if (!contains(joints_, node.joint))
            note(place + "/joint", "joint", catalog_.joints[node.joint].id);
        look_at(node.effector, place + "/effector/source");
        for (std::size_t i = 0; i < node.further.size(); ++i)
            look_at(node.further[i].effector,
                    fmt::format("{}/further/{}/effector/source", place, i));
        look_at(node.organs, place + "/organs");
        look_at(node.neurons, place + "/neurons");
    }
    void look_at(const std::vector<NeuronGene>& neurons, const std::string& place) {
        for (std::size_t i = 0; i < neurons.size(); ++i) {
            const std::string neuron = fmt::format("{}/{}", place, i);
            if (!contains(functions_, neurons[i].function))
                note(neuron + "/fn", "function", catalog_.functions[neurons[i].function].id);
            for (std::size_t j = 0; j < neurons[i].inputs.size(); ++j)
                look_at(neurons[i].inputs[j], fmt::format("{}/in/{}/from", neuron, j));
        }
    }
    void look_at(const std::vector<OrganGene>& organs, const std::string& place) {
        for (std::size_t i = 0; i < organs.size(); ++i) {
            const std::string organ = fmt::format("{}/{}", place, i);
            if (!contains(organs_, organs[i].kind))
                note(organ + "/kind", "organ", catalog_.organs[organs[i].kind].id);
            look_at(organs[i].input, organ + "/source");
        }
    }
    std::vector<DisabledKind> take() { return std::move(found_); }

private:
    void look_at(const InputGene& input, const std::string& place) {
        const std::uint8_t channel = input.source.index;
        if (source_rule(input.source.kind).reads != SourceReads::kSensor) return;
        if (channel < catalog_.channels.size() && !contains(channels_, channel))
            note(place + "/ch", "sensor", catalog_.channels[channel].id);
    }
    void note(std::string place, const char* sort, const std::string& id) {
        const std::string what = fmt::format("{} \"{}\"", sort, id);
        const bool noted = std::any_of(found_.begin(), found_.end(),
                                       [&](const DisabledKind& kind) { return kind.what == what; });
        if (!noted) found_.push_back({std::move(place), what});
    }

    const KindCatalog& catalog_;
    std::vector<std::uint8_t> functions_;
    std::vector<std::uint8_t> joints_;
    std::vector<std::uint8_t> organs_;
    std::vector<std::uint8_t> channels_;
    std::vector<DisabledKind> found_;
};

}  // namespace

std::vector<DisabledKind> disabled_kinds(const Genome& genome, const FounderSettings& settings,
                                         const KindCatalog& catalog) {
    Search search(settings, catalog);
    for (std::size_t i = 0; i < genome.nodes.size(); ++i)
        search.look_at(genome.nodes[i], fmt::format("/nodes/{}", i));
    search.look_at(genome.brain, "/brain");
    return search.take();
}

}  // namespace cambrian
