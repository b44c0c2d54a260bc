#include "genome/founders/random_genome.h"

#include "genome/founders/enabled_kinds.h"
#include "genome/small_catalog.h"
#include "genome/source_rules.h"
#include "support/catch.h"

#include <algorithm>

using namespace cambrian;

namespace {

std::vector<Genome> founders(const FounderSettings& settings, int count) {
    const KindCatalog catalog = small_catalog();
    std::vector<Genome> genomes;
    for (int i = 0; i < count; ++i) {
        RandomStream stream(stream_seed(1, 0, static_cast<std::uint64_t>(i), Purpose::kTest));
        genomes.push_back(random_genome(settings, catalog, stream));
    }
    return genomes;
}

// Returns flags that enable only the named kinds.
template <class Entry>
std::map<std::string, bool> only(const std::vector<Entry>& entries,
                                 const std::vector<std::string>& ids) {
    std::map<std::string, bool> flags;
    for (const Entry& entry : entries)
        flags[entry.id] = std::find(ids.begin(), ids.end(), entry.id) != ids.end();
    return flags;
}

}  // namespace

TEST_CASE("random genomes are valid and within the user's limits", "[genome][random]") {
    FounderSettings settings;
    settings.min_nodes = 3;
    settings.max_nodes = 7;
    settings.max_length = 0.6;
    settings.max_node_neurons = 2;
    settings.functions = only(small_catalog().functions, {"sum", "abs"});
    for (const Genome& genome : founders(settings, 3000)) {
        REQUIRE(validate(genome, small_catalog()).empty());
        REQUIRE(genome.nodes.size() >= 3);
        REQUIRE(genome.nodes.size() <= 7);
        for (const NodeGene& node : genome.nodes) {
            REQUIRE(node.length >= settings.min_length);
            REQUIRE(node.length <= settings.max_length);
            REQUIRE(node.neurons.size() <= 2);
            for (const NeuronGene& neuron : node.neurons)
                REQUIRE((neuron.function == 0 || neuron.function == 2));
        }
    }
}

TEST_CASE("random genomes use rigid and revolute joints unless settings name others",
          "[genome][random]") {
    FounderSettings settings;
    CHECK(enabled_joints(settings, small_catalog()) == std::vector<std::uint8_t>{0, 1});
    std::size_t rotary = 0;
    std::size_t nodes = 0;
    for (const Genome& genome : founders(settings, 2000)) {
        for (const NodeGene& node : genome.nodes) {
            REQUIRE(node.joint <= 1);
            rotary += node.joint;
            ++nodes;
        }
    }
    CHECK(static_cast<double>(rotary) / static_cast<double>(nodes) == Approx(0.8).margin(0.03));
    settings.joints = only(small_catalog().joints, {"linear"});
    for (const Genome& genome : founders(settings, 50))
        CHECK(genome.nodes.back().joint == 2);
}

TEST_CASE("new genes read only the sensor channels allowed, or none", "[genome][random]") {
    FounderSettings settings;
    settings.channels = only(small_catalog().channels, {small_catalog().channels[1].id});
    std::size_t sensors = 0;
    const auto check = [&](const InputGene& input) {
        if (source_rule(input.source.kind).reads != SourceReads::kSensor) return;
        REQUIRE(input.source.index == 1);
        ++sensors;
    };
    const auto check_all = [&](const std::vector<Genome>& genomes) {
        for (const Genome& genome : genomes) {
            for (const NodeGene& node : genome.nodes) {
                check(node.effector);
                for (const NeuronGene& neuron : node.neurons)
                    std::for_each(neuron.inputs.begin(), neuron.inputs.end(), check);
            }
        }
    };
    check_all(founders(settings, 200));
    CHECK(sensors > 100);
    sensors = 0;
    settings.channels = only(small_catalog().channels, {});
    check_all(founders(settings, 200));
    CHECK(sensors == 0);
}

TEST_CASE("the same stream draws the same founder, another one another", "[genome][random]") {
    const std::vector<Genome> genomes = founders({}, 2);
    CHECK(genomes[0] == founders({}, 1)[0]);
    CHECK_FALSE(genomes[0] == genomes[1]);
}

TEST_CASE("contradictory limits still give a valid genome", "[genome][random]") {
    FounderSettings settings;
    settings.min_nodes = 40;
    settings.max_nodes = -3;
    settings.max_recursion = 0;
    settings.max_length = 10.0;
    settings.max_brain_neurons = -1;
    for (const Genome& genome : founders(settings, 200))
        REQUIRE(validate(genome, small_catalog()).empty());
}

TEST_CASE("founders' oscillators mostly get constants in the suggested range", "[genome][random]") {
    FounderSettings settings;
    settings.functions = only(small_catalog().functions, {"oscillate-wave"});
    int suggested = 0;
    int all = 0;
    for (const Genome& genome : founders(settings, 1000)) {
        for (const NeuronGene& neuron : genome.brain) {
            const InputGene& frequency = neuron.inputs[0];
            suggested += frequency.source.kind == SourceKind::kConstant &&
                         frequency.weight >= 0.3 && frequency.weight <= 2.0;
            ++all;
        }
    }
    CHECK(static_cast<double>(suggested) / all > 0.78);
}

TEST_CASE("limbs of rhythmic founders follow oscillators of one frequency", "[genome][random]") {
    FounderSettings settings;
    settings.rhythmic_share = 1.0;
    int pairs = 0;
    for (const Genome& genome : founders(settings, 500)) {
        REQUIRE(validate(genome, small_catalog()).empty());
        const double frequency = genome.nodes[0].neurons.back().inputs[0].weight;
        CHECK(frequency >= 0.3);
        CHECK(frequency <= 2.0);
        for (const NodeGene& node : genome.nodes) {
            const NeuronGene& neuron = node.neurons.back();
            CHECK(small_catalog().functions[neuron.function].id == "oscillate-wave");
            CHECK(neuron.inputs[0].source.kind == SourceKind::kConstant);
            CHECK(neuron.inputs[0].weight == frequency);
            CHECK(node.effector.source == own_neuron(SourceScope::kPart, node.neurons.size() - 1));
            pairs += node.symmetric ? 1 : 0;
        }
    }
    CHECK(pairs > 300);
}

TEST_CASE("founders are as rhythmic as the settings say", "[genome][random]") {
    FounderSettings settings;
    const auto rhythmic = [&] {
        int count = 0;
        for (const Genome& genome : founders(settings, 2000)) {
            count +=
                std::all_of(genome.nodes.begin(), genome.nodes.end(), [](const NodeGene& node) {
                    return !node.neurons.empty() &&
                           node.effector.source ==
                               own_neuron(SourceScope::kPart, node.neurons.size() - 1);
                });
        }
        return count;
    };
    CHECK(rhythmic() < 200);
    settings.rhythmic_share = 0.5;
    CHECK(rhythmic() == Approx(1000).margin(150));
    // Without oscillators, or where joints may not follow neurons, nobody is.
    settings.rhythmic_share = 1.0;
    settings.functions["oscillate-wave"] = false;
    CHECK(rhythmic() < 200);
    settings.functions.clear();
    settings.references["localNeuron"] = false;
    CHECK(rhythmic() < 200);
}

TEST_CASE("rhythmic founders keep to contradictory limits", "[genome][random]") {
    FounderSettings settings;
    settings.rhythmic_share = 1.0;
    settings.min_nodes = 40;
    settings.max_nodes = -3;
    settings.max_recursion = 0;
    settings.max_node_neurons = 9;
    for (const Genome& genome : founders(settings, 200))
        REQUIRE(validate(genome, small_catalog()).empty());
}
