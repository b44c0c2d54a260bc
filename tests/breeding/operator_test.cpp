// The effect of single operators of breeding/README.md 3 on hand-made genomes.

#include "breeding/corpora.h"
#include "support/catch.h"

using namespace cambrian;

namespace {

std::uint8_t function(std::string_view id) {
    return static_cast<std::uint8_t>(builtin_neuron_functions().index_of(id).value());
}

SourceRef local(int neuron) {
    return {SourceKind::kLocalNeuron, static_cast<std::uint8_t>(neuron)};
}

NeuronGene absolute_of(const SourceRef& source) {
    return {function("abs"), {{source, 1.0}}};
}

// Applies one operator once; it must be applicable.
Genome after(const std::string& id, const Genome& genome, std::uint64_t number) {
    static const MutationRegistry mutations = builtin_mutations();
    RandomStream stream = test_stream(number);
    Genome changed = genome;
    MutationRecord record;
    REQUIRE(mutations.find(id)->apply(changed, default_context(), stream, record));
    return changed;
}

Genome body_and_limb() {
    Genome genome;
    genome.nodes.resize(2);
    genome.nodes[0].edges = {{.target = 1, .position = 0.3}};
    return genome;
}

// Neurons 0 to 2 of the root read a sensor, neuron 0 and neuron 1; its effector reads neuron 2.
Genome chain_of_neurons() {
    Genome genome;
    genome.nodes.resize(1);
    genome.nodes[0].neurons = {absolute_of({SourceKind::kLocalSensor, 4}), absolute_of(local(0)),
                               absolute_of(local(1))};
    genome.nodes[0].effector.source = local(2);
    return genome;
}

}  // namespace

TEST_CASE("removing a neuron reconnects its listeners to what it heard", "[breeding][operators]") {
    int seen = 0;
    for (std::uint64_t number = 0; number < 30; ++number) {
        const NodeGene root = after("remove-neuron", chain_of_neurons(), number).nodes[0];
        REQUIRE(root.neurons.size() == 2);
        const SourceRef first = root.neurons[0].inputs[0].source;
        REQUIRE(first == SourceRef{SourceKind::kLocalSensor, 4});
        REQUIRE(root.neurons[1].inputs[0].source == local(0));
        REQUIRE(root.effector.source == local(1));
        ++seen;
    }
    CHECK(seen == 30);
}

TEST_CASE("removing a neuron that hears itself leaves a constant", "[breeding][operators]") {
    Genome genome = chain_of_neurons();
    genome.nodes[0].neurons = {absolute_of(local(0))};
    genome.nodes[0].effector.source = local(3);
    const NodeGene root = after("remove-neuron", genome, 1).nodes[0];
    CHECK(root.neurons.empty());
    CHECK(root.effector.source == SourceRef{});
}

TEST_CASE("references beyond the list keep their neuron when another is removed",
          "[breeding][operators]") {
    Genome genome = chain_of_neurons();
    genome.nodes[0].effector.source = local(5);  // neuron 2 of 3
    for (std::uint64_t number = 0; number < 10; ++number)
        CHECK(after("remove-neuron", genome, number).nodes[0].effector.source == local(1));
}

TEST_CASE("a new neuron takes over a link and mostly passes its source on",
          "[breeding][operators]") {
    Genome genome = body_and_limb();
    genome.nodes.resize(1);
    genome.nodes[0].edges.clear();
    genome.nodes[0].effector.source = {SourceKind::kLocalSensor, 2};
    int passed_on = 0;
    for (std::uint64_t number = 0; number < 1000; ++number) {
        const NodeGene root = after("add-neuron", genome, number).nodes[0];
        REQUIRE(root.neurons.size() == 1);
        REQUIRE(root.effector.source == local(0));
        passed_on += root.neurons[0].inputs[0].source == genome.nodes[0].effector.source;
    }
    // The expected share is 0.7, plus what a random draw gives by chance.
    CHECK(passed_on == Approx(700).margin(60));
}

TEST_CASE("a reflex adds the signal of a sensor to what moves a joint", "[breeding][operators]") {
    Genome genome = body_and_limb();
    for (NodeGene& node : genome.nodes)
        node.effector = {{SourceKind::kParentNeuron, 3}, 0.7};
    std::array<int, 2> grown{};
    for (std::uint64_t number = 0; number < 1000; ++number) {
        const Genome changed = after("add-reflex", genome, number);
        const std::size_t index = changed.nodes[0].neurons.empty() ? 1 : 0;
        const NodeGene& node = changed.nodes[index];
        ++grown[index];
        REQUIRE(node.effector == InputGene{local(0), 0.7});
        REQUIRE(node.neurons.size() == 1);
        REQUIRE(node.neurons[0].function == function("sum"));
        REQUIRE(node.neurons[0].inputs[0] == InputGene{genome.nodes[index].effector.source, 1.0});
        const InputGene& sensor = node.neurons[0].inputs[1];
        REQUIRE(sensor.source.kind == SourceKind::kLocalSensor);
        REQUIRE(std::abs(sensor.weight) <= 1.0);
        REQUIRE(node.neurons[0].inputs[2] == InputGene{{}, 0.0});
        REQUIRE(validate(changed, full_catalog()).empty());
    }
    CHECK(grown[0] == Approx(500).margin(70));
}

TEST_CASE("no reflex grows without sensors, without sums or without room",
          "[breeding][operators]") {
    const MutationRegistry mutations = builtin_mutations();
    const MutationKind& kind = *mutations.find("add-reflex");
    RandomStream stream = test_stream(1);
    MutationRecord record;
    Genome full = body_and_limb();
    for (NodeGene& node : full.nodes)
        node.neurons.resize(gene_range::kMaxNodeNeurons, absolute_of(local(0)));
    CHECK_FALSE(kind.apply(full, default_context(), stream, record));
    FounderSettings blind;
    for (const ChannelEntry& channel : full_catalog().channels)
        blind.channels[channel.id] = false;
    Genome genome = body_and_limb();
    CHECK_FALSE(kind.apply(genome, {full_catalog(), blind}, stream, record));
    const FounderSettings without_sums{.functions = {{"sum", false}}};
    CHECK_FALSE(kind.apply(genome, {full_catalog(), without_sums}, stream, record));
}

TEST_CASE("a new part hangs on an old one", "[breeding][operators]") {
    int copies = 0;
    int pairs = 0;
    Genome genome = body_and_limb();
    genome.nodes[1].symmetric = true;
    for (std::uint64_t number = 0; number < 1000; ++number) {
        const Genome grown = after("add-node", genome, number);
        REQUIRE(grown.nodes.size() == 3);
        const auto to_new = [](const EdgeGene& edge) { return edge.target == 2; };
        const auto edges =
            std::count_if(grown.nodes[0].edges.begin(), grown.nodes[0].edges.end(), to_new) +
            std::count_if(grown.nodes[1].edges.begin(), grown.nodes[1].edges.end(), to_new);
        REQUIRE(edges >= 1);
        REQUIRE((edges == 1 || grown.nodes[2].symmetric));
        copies += grown.nodes[2].length == genome.nodes[0].length;
        pairs += edges == 2;
    }
    CHECK(copies == Approx(500).margin(60));
    CHECK(pairs == Approx(250).margin(50));  // half of the new parts are symmetric
}

TEST_CASE("a duplicated edge stays in place only towards a symmetric part",
          "[breeding][operators]") {
    Genome genome = body_and_limb();
    genome.nodes.resize(2);
    const auto same_place = [&](bool symmetric) {
        genome.nodes[1].symmetric = symmetric;
        int same = 0;
        for (std::uint64_t number = 0; number < 1000; ++number) {
            const auto edges = after("add-edge", genome, number).nodes[0].edges;
            same += edges.size() == 2 && edges[1] == edges[0];
        }
        return same;
    };
    CHECK(same_place(true) > 300);
    CHECK(same_place(false) == 0);
}

TEST_CASE("retargeting chooses another part", "[breeding][operators]") {
    for (std::uint64_t number = 0; number < 20; ++number)
        CHECK(after("retarget", body_and_limb(), number).nodes[0].edges[0].target == 0);
}

TEST_CASE("a new function keeps inputs, drops extra ones and draws missing ones",
          "[breeding][operators]") {
    const Genome genome = chain_of_neurons();
    for (std::uint64_t number = 0; number < 200; ++number) {
        const Genome changed = after("function", genome, number);
        for (std::size_t i = 0; i < 3; ++i) {
            const NeuronGene& neuron = changed.nodes[0].neurons[i];
            const int arity = full_catalog().functions[neuron.function].arity;
            REQUIRE(neuron.inputs.size() == static_cast<std::size_t>(arity));
            REQUIRE(neuron.inputs[0] == genome.nodes[0].neurons[i].inputs[0]);
        }
    }
}

TEST_CASE("recursion limits step by one and bounce off their bounds", "[breeding][operators]") {
    Genome genome = body_and_limb();
    for (const int limit : {1, gene_range::kMaxRecursion}) {
        genome.nodes[0].recursion_limit = genome.nodes[1].recursion_limit = limit;
        for (std::uint64_t number = 0; number < 100; ++number) {
            for (const NodeGene& node : after("node-discrete", genome, number).nodes) {
                REQUIRE(node.recursion_limit >= 1);
                REQUIRE(node.recursion_limit <= gene_range::kMaxRecursion);
                REQUIRE(std::abs(node.recursion_limit - limit) <= 1);
            }
        }
    }
}
