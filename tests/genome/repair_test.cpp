#include "genome/genome.h"
#include "genome/random_garbage.h"
#include "genome/small_catalog.h"
#include "support/build_speed.h"
#include "support/catch.h"

using namespace cambrian;

namespace {

NodeGene node_with_edges(std::initializer_list<int> targets) {
    NodeGene node;
    for (const int target : targets)
        node.edges.push_back({.target = static_cast<std::uint8_t>(target)});
    return node;
}

}  // namespace

TEST_CASE("repair makes any garbage valid and is idempotent", "[genome][repair]") {
    const KindCatalog catalog = small_catalog();
    RandomStream stream(stream_seed(1, 0, 0, Purpose::kTest));
    for (int i = 0; i < test::by_build(6000, 1500); ++i) {
        Genome genome = garbage_genome(stream);
        repair(genome, catalog);
        const auto complaints = validate(genome, catalog);
        INFO(i << ": " << (complaints.empty() ? "" : complaints.front()));
        REQUIRE(complaints.empty());
        Genome again = genome;
        repair(again, catalog);
        REQUIRE(again == genome);
        REQUIRE(genome_hash(again) == genome_hash(genome));
    }
}

TEST_CASE("repair leaves a valid genome's numbers alone, at the ends of their ranges too",
          "[genome][repair]") {
    Genome genome;
    genome.nodes = {NodeGene{}};
    genome.nodes[0].length = gene_range::kMaxLength;
    genome.nodes[0].limit_low = -gene_range::kMinLimit;
    genome.root_angle = -3.14159265358979323846;
    const Genome before = genome;
    repair(genome, small_catalog());
    CHECK(genome == before);
}

TEST_CASE("repair reflects at bounds, wraps circles and replaces non-numbers", "[genome][repair]") {
    Genome genome;
    genome.nodes = {node_with_edges({0})};
    genome.nodes[0].length = 1.7;
    genome.nodes[0].width = std::numeric_limits<double>::quiet_NaN();
    genome.nodes[0].edges[0].position = 1.25;
    repair(genome, small_catalog());
    CHECK(genome.nodes[0].length == Approx(1.5));
    CHECK(genome.nodes[0].width == 0.2);
    CHECK(genome.nodes[0].edges[0].position == 0.25);
}

TEST_CASE("repair puts nodes in breadth-first order and drops unreachable ones",
          "[genome][repair]") {
    Genome genome;
    genome.nodes = {node_with_edges({3, 1}), node_with_edges({}), node_with_edges({0}),
                    node_with_edges({4}), node_with_edges({1})};
    for (std::size_t i = 0; i < genome.nodes.size(); ++i)
        genome.nodes[i].uid = static_cast<std::uint32_t>(i);
    repair(genome, small_catalog());
    REQUIRE(genome.nodes.size() == 4);
    CHECK(genome.nodes[1].uid == 3);
    CHECK(genome.nodes[2].uid == 1);
    CHECK(genome.nodes[3].uid == 4);
    CHECK(genome.nodes[1].edges[0].target == 3);
}

TEST_CASE("repair cuts the end of the canonical order off a genome of too many nodes",
          "[genome][repair]") {
    Genome genome;
    for (int i = 0; i < 20; ++i)
        genome.nodes.push_back(node_with_edges({i + 1}));
    repair(genome, small_catalog());
    CHECK(genome.nodes.size() == 16);
    CHECK(genome.nodes[15].edges.empty());
    CHECK(validate(genome, small_catalog()).empty());
}

TEST_CASE("repair gives a neuron exactly the inputs its function takes", "[genome][repair]") {
    Genome genome;
    genome.brain = {{.function = 0, .inputs = {}}, {.function = 2, .inputs = {{}, {}, {}}}};
    repair(genome, small_catalog());
    REQUIRE(genome.brain[0].inputs.size() == 3);
    CHECK(genome.brain[0].inputs[2] == InputGene{.source = {}, .weight = 0.0});
    CHECK(genome.brain[1].inputs.size() == 1);
}
