// Deformers from the gene to the scene.

#include "creature/builders.h"
#include "creature/creature.h"
#include "planar/planar_scene.h"
#include "support/catch.h"

#include <algorithm>

using namespace cambrian;

namespace {

std::uint8_t organ_kind(std::string_view id) {
    return static_cast<std::uint8_t>(kinds().organs.index_of(id).value());
}

OrganGene deformer(const InputGene& input, double low = -0.4, double high = 0.2) {
    return {.kind = organ_kind("deformer"), .input = input, .parameters = {low, high}};
}

// A chain of parts that all have a deformer.
Genome deforming_chain(int parts) {
    std::vector<NodeGene> nodes(static_cast<std::size_t>(parts));
    Genome genome;
    for (int i = 0; i < parts; ++i) {
        NodeGene& node = nodes[static_cast<std::size_t>(i)];
        node.length = 0.2;
        node.width = 0.1;
        node.joint = 0;
        node.organs = {deformer(constant(1.0))};
        if (i + 1 < parts) node.edges = {edge_to(static_cast<std::size_t>(i) + 1)};
    }
    genome.nodes = nodes;
    return genome;
}

std::size_t deforming_parts(const Phenotype& phenotype) {
    const auto& parts = phenotype.plan.parts;
    return static_cast<std::size_t>(
        std::count_if(parts.begin(), parts.end(),
                      [](const PlannedPart& part) { return part.stretch.has_value(); }));
}

}  // namespace

TEST_CASE("a deformer makes its part deformable, as strong as its area", "[creature][deformer]") {
    NodeGene node;
    node.length = 0.5;
    node.width = 0.2;
    node.organs = {deformer(constant(1.0))};
    const Phenotype phenotype = express(genome_of({node}));
    const PlannedPart& part = phenotype.plan.parts[0];
    REQUIRE(part.stretch);
    CHECK(part.stretch->low == -0.4);
    CHECK(part.stretch->high == 0.2);
    CHECK(part.stretch->max_effort == Approx(SceneSettings{}.muscle_strength * 0.1));
    CHECK(part.stretch->rate_limit == 1.5);
    CHECK(phenotype.organs[0].deforms);
}

TEST_CASE("a creature without joints can move if a part deforms by more than a constant",
          "[creature][deformer]") {
    NodeGene node;
    node.organs = {deformer(constant(1.0))};
    CHECK(express(genome_of({node})).can_move());
    CHECK_FALSE(express(genome_of({node})).has_live_control);
    node.neurons = {oscillator(1.0)};
    node.organs = {deformer(local_neuron(0))};
    CHECK(express(genome_of({node})).has_live_control);
    node.organs = {{.kind = organ_kind("scent"), .input = local_neuron(0)}};
    CHECK_FALSE(express(genome_of({node})).can_move());
}

TEST_CASE("the target of a deformer is its signal, limited and smoothed", "[creature][deformer]") {
    NodeGene node;
    node.organs = {deformer(constant(-3.0))};
    const Phenotype phenotype = express(genome_of({node}));
    const SceneSettings settings;
    Creature creature(phenotype, kinds(), settings);
    FakeScene scene(1);
    creature.act(scene, FakeSurroundings(), 1.0 / 60);
    const double first = scene.stretch_targets[0];
    CHECK(first < 0.0);
    CHECK(first > -0.4);
    const Creature::State saved = creature.save();
    for (int tick = 0; tick < 300; ++tick)
        creature.act(scene, FakeSurroundings(), 1.0 / 60);
    CHECK(scene.stretch_targets[0] == Approx(-0.4));
    creature.restore(saved);
    creature.act(scene, FakeSurroundings(), 1.0 / 60);
    CHECK(scene.stretch_targets[0] > -0.4);
    creature.hold_rest(scene);
    CHECK(scene.stretch_targets[0] == 0.0);
}

TEST_CASE("mirrored parts deform alike", "[creature][deformer]") {
    NodeGene leg;
    leg.symmetric = true;
    leg.organs = {deformer(constant(1.0))};
    const Phenotype phenotype =
        express(genome_of({node_with({edge_to(1, 0.3, 0.4), edge_to(1, 0.8, -1.0)}), leg}));
    REQUIRE(phenotype.parts.size() == 3);
    REQUIRE(phenotype.parts[1].mirror.across == -phenotype.parts[2].mirror.across);
    const SceneSettings settings;
    Creature creature(phenotype, kinds(), settings);
    FakeScene scene(3);
    creature.act(scene, FakeSurroundings(), 1.0 / 60);
    CHECK(scene.stretch_targets[1] > 0.0);
    CHECK(scene.stretch_targets[1] == scene.stretch_targets[2]);
}

TEST_CASE("at most 16 parts deform, and as many as physics has room for", "[creature][deformer]") {
    ExpressionSettings settings;
    settings.max_parts = 32;
    settings.max_depth = 32;
    for (const int copies : {2, 3}) {
        Genome genome = deforming_chain(8);
        for (NodeGene& node : genome.nodes)
            node.recursion_limit = copies;
        genome.nodes.back().edges = {edge_to(0)};
        const Phenotype phenotype = express(genome, settings);
        const std::size_t parts = phenotype.parts.size();
        CAPTURE(parts);
        CHECK(parts > 8);
        CHECK(deforming_parts(phenotype) == std::min<std::size_t>(16, 32 - parts));
        CHECK(planar_scene_kind().make(phenotype.plan, Environment{}, SceneSettings{}));
    }
}

TEST_CASE("genes cannot have two deformers in a part", "[creature][deformer]") {
    Genome genome = deforming_chain(1);
    genome.nodes[0].organs.push_back(deformer(constant(1.0), -0.2, 0.4));
    const auto complaints = validate(genome, kinds().catalog);
    REQUIRE(complaints.size() == 1);
    CHECK(complaints[0] ==
          "/nodes/0/organs/1/kind: is a second deformer, but a part has at most one");
    repair(genome, kinds().catalog);
    CHECK(validate(genome, kinds().catalog).empty());
    CHECK(genome.nodes[0].organs == deforming_chain(1).nodes[0].organs);
}

TEST_CASE("limits of a deformer of the wrong sign are refused", "[creature][deformer]") {
    Genome genome = deforming_chain(1);
    genome.nodes[0].organs[0].parameters = {0.1, 0.3};
    CHECK(validate(genome, kinds().catalog) ==
          std::vector<std::string>{"/nodes/0/organs/0/low: 0.1 is outside [-0.5, -0.05]"});
    genome.nodes[0].organs[0].parameters = {-0.1, -0.3};
    CHECK(validate(genome, kinds().catalog) ==
          std::vector<std::string>{"/nodes/0/organs/0/high: -0.3 is outside [0.05, 0.5]"});
}

TEST_CASE("founders have deformers in 15 per cent of parts if the kind is enabled",
          "[creature][deformer]") {
    FounderSettings founders;
    int parts = 0;
    int deformers = 0;
    for (const bool enabled : {false, true}) {
        founders.organs["deformer"] = enabled;
        for (std::uint64_t i = 0; i < 400; ++i) {
            RandomStream stream(stream_seed({77, i}));
            const Genome genome = random_genome(founders, kinds().catalog, stream);
            REQUIRE(validate(genome, kinds().catalog).empty());
            for (const NodeGene& node : genome.nodes) {
                if (!enabled) CHECK(node.organs.empty());
                if (enabled) ++parts;
                deformers += static_cast<int>(node.organs.size());
            }
        }
    }
    CHECK(deformers == Approx(0.15 * parts).epsilon(0.2));
}
