#include "creature/builders.h"
#include "creature/creature.h"
#include "support/catch.h"

using namespace cambrian;

namespace {

SourceRef reference(SourceKind kind, int index, int child = 0, int node = 0, int instance = 0) {
    return {kind, static_cast<std::uint8_t>(index), static_cast<std::uint8_t>(child),
            static_cast<std::uint8_t>(node), static_cast<std::uint8_t>(instance)};
}

// Returns a root and two arms, in order of creation. Neuron k of part p has the value (10 p + k) /
// 100. The first arm's effector reads `heard`.
Genome two_arms(const SourceRef& heard) {
    const auto teller = [](int part, int neuron) {
        const double value = (10.0 * part + neuron) / 100.0;
        return NeuronGene{function("sum"), {constant(value), constant(0), constant(0)}};
    };
    NodeGene root = node_with({edge_to(1, 0.3), edge_to(2, 0.8)});
    root.neurons = {teller(0, 0), teller(0, 1)};
    NodeGene first;
    first.neurons = {teller(1, 0), teller(1, 1), teller(1, 2)};
    first.effector = {heard, 1.0};
    NodeGene second = node_with({edge_to(1, 0.125)});
    second.neurons = {teller(2, 0)};
    Genome genome = genome_of({root, first, second});
    genome.brain = {teller(5, 0), teller(5, 1)};
    return genome;
}

// Returns the value that a part's effector reads in the first tick.
double heard_by(std::size_t part, const Genome& genome) {
    const Phenotype phenotype = express(genome);
    Brain brain(phenotype.network, kinds().functions);
    brain.think(1.0 / 60.0);
    for (std::size_t i = 0; i < phenotype.effectors.size(); ++i) {
        if (phenotype.effectors[i].part == part) return brain.output(i);
    }
    FAIL("no such effector");
    return 0.0;
}

double heard_by_first_arm(const SourceRef& source) {
    return heard_by(1, two_arms(source));
}

}  // namespace

TEST_CASE("references within a part and to its parent resolve modulo what is there",
          "[creature][wiring]") {
    CHECK(heard_by_first_arm(reference(SourceKind::kLocalNeuron, 1)) == Approx(0.11));
    CHECK(heard_by_first_arm(reference(SourceKind::kLocalNeuron, 5)) == Approx(0.12));
    CHECK(heard_by_first_arm(reference(SourceKind::kParentNeuron, 15)) == Approx(0.01));
    CHECK(heard_by_first_arm(reference(SourceKind::kBrainNeuron, 2)) == Approx(0.50));
}

TEST_CASE("references to children go to the e-th created, or read 0 without any",
          "[creature][wiring]") {
    CHECK(heard_by_first_arm(reference(SourceKind::kChildNeuron, 0)) == 0.0);
    Genome genome = two_arms({});
    genome.nodes[2].effector = {reference(SourceKind::kChildNeuron, 2, 7), 1.0};
    CHECK(heard_by(2, genome) == Approx(0.12));
}

TEST_CASE("central neurons hear parts by node and instance", "[creature][wiring]") {
    Genome genome = two_arms(reference(SourceKind::kBrainNeuron, 0));
    genome.nodes[1].neurons = {{function("abs"), {{reference(SourceKind::kParentNeuron, 0), 1.0}}}};
    const auto instance = [&](int node, int number) {
        const SourceRef part = reference(SourceKind::kPartNeuron, 0, 0, node, number);
        genome.brain[0] = {function("abs"), {{part, 1.0}}};
        return heard_by(1, genome);
    };
    CHECK(instance(1, 0) == Approx(0.0));   // the copy on the root
    CHECK(instance(1, 1) == Approx(0.20));  // the copy on the second arm
    CHECK(instance(1, 3) == Approx(0.20));
    CHECK(instance(5, 0) == Approx(0.20));  // node 5 mod 3
}

TEST_CASE("the parent of the root, missing neurons and unknown channels read 0",
          "[creature][wiring]") {
    CHECK(heard_by_first_arm(reference(SourceKind::kLocalSensor, 200)) == 0.0);
    Genome genome = two_arms(reference(SourceKind::kParentNeuron, 0));
    genome.nodes[0].neurons = {{function("abs"), {{reference(SourceKind::kParentSensor, 1), 1.0}}}};
    CHECK(heard_by(1, genome) == 0.0);
    genome.nodes[0].neurons.clear();
    CHECK(heard_by(1, genome) == 0.0);
}

TEST_CASE("only sensors somebody hears are read", "[creature][wiring]") {
    Genome genome = two_arms(reference(SourceKind::kLocalSensor, 3));
    genome.nodes[2].neurons[0].inputs[0] = {reference(SourceKind::kLocalSensor, 1), 1.0};
    const Phenotype phenotype = express(genome);  // no effector reads part 2's neuron
    REQUIRE(phenotype.sensors.size() == 2);
    CHECK(phenotype.sensors[0].part == 1);
    CHECK(phenotype.sensors[1].part == 3);
    CHECK(phenotype.sensors[0].kind == 1);
    CHECK(phenotype.sensors[0].channel == 2);
    CHECK(phenotype.network.sensor_count == 2);
    CHECK(phenotype.network.order.empty());
}

TEST_CASE("control is live if an effector hears a sensor, a memory or a cycle",
          "[creature][wiring]") {
    const auto live = [](const SourceRef& source) {
        return express(two_arms(source)).has_live_control;
    };
    CHECK_FALSE(live({}));
    CHECK_FALSE(live(reference(SourceKind::kLocalNeuron, 0)));
    CHECK(live(reference(SourceKind::kLocalSensor, 0)));
    Genome genome = two_arms(reference(SourceKind::kLocalNeuron, 0));
    genome.nodes[1].neurons[0] = oscillator(1.0);
    CHECK(express(genome).has_live_control);
    genome.nodes[1].neurons[0] = {function("abs"), {local_neuron(0)}};
    CHECK(express(genome).has_live_control);
}

TEST_CASE("rigid parts have no effector", "[creature][wiring]") {
    Genome genome = two_arms({});
    genome.nodes[2].joint = 0;
    CHECK(express(genome).effectors == std::vector<JointDegree>{{1}, {3}});
    genome.nodes[1].joint = 0;
    CHECK_FALSE(express(genome).can_move());
}
