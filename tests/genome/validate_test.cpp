#include "genome/genome.h"
#include "genome/small_catalog.h"
#include "support/catch.h"

using namespace cambrian;

namespace {

Genome two_parts() {
    Genome genome;
    genome.nodes.resize(2);
    genome.nodes[0].edges = {{.target = 1}};
    return genome;
}

std::string only_complaint(const Genome& genome) {
    const auto complaints = validate(genome, small_catalog());
    REQUIRE(complaints.size() == 1);
    return complaints.front();
}

}  // namespace

TEST_CASE("a plain creature of two parts is valid", "[genome][validate]") {
    CHECK(validate(two_parts(), small_catalog()).empty());
}

TEST_CASE("a genome without parts is not valid", "[genome][validate]") {
    CHECK(only_complaint(Genome{}) == "/nodes: 0 entries, allowed are 1 to 16");
}

TEST_CASE("validate names the place and the range of a number outside it", "[genome][validate]") {
    Genome genome = two_parts();
    genome.nodes[1].limit_low = 0.4;
    CHECK(only_complaint(genome) == "/nodes/1/limits/0: 0.4 is outside [-2.6, -0.05]");
}

TEST_CASE("validate finds wrong input counts and sources out of place", "[genome][validate]") {
    Genome genome = two_parts();
    genome.brain = {{.function = 0, .inputs = {{}, {}}}};
    CHECK(only_complaint(genome) == "/brain/0/in: function \"sum\" needs 3 inputs, found 2");
    genome.brain = {{.function = 2, .inputs = {{.source = {SourceKind::kParentNeuron}}}}};
    CHECK(only_complaint(genome) == "/brain/0/in/0/from/kind: is only for part neurons");
    genome.brain.clear();
    genome.nodes[0].effector.source.kind = SourceKind::kPartSensor;
    CHECK(only_complaint(genome) == "/nodes/0/effector/from/kind: is only for central neurons");
}

TEST_CASE("validate finds unknown kinds", "[genome][validate]") {
    Genome genome = two_parts();
    genome.nodes[1].joint = 3;
    CHECK(only_complaint(genome) == "/nodes/1/joint: is not a known joint");
    genome = two_parts();
    genome.nodes[1].neurons = {{.function = 200, .inputs = {}}};
    CHECK(only_complaint(genome) == "/nodes/1/neurons/0/fn: is not a known function");
}

TEST_CASE("validate finds what is wrong with organs", "[genome][validate]") {
    Genome genome = two_parts();
    genome.nodes[1].organs = {{.kind = 0, .parameters = {2.0}}, {.kind = 1}};
    CHECK(validate(genome, small_catalog()).empty());
    const auto complaint_after = [&](auto change) {
        Genome changed = genome;
        change(changed.nodes[1].organs);
        return only_complaint(changed);
    };
    using Organs = std::vector<OrganGene>;
    CHECK(complaint_after([](Organs& organs) { organs[1].kind = 3; }) ==
          "/nodes/1/organs/1/kind: is not a known organ");
    CHECK(complaint_after([](Organs& organs) {
              organs[1].kind = 2;
              organs.push_back({.kind = 2});
          }) == "/nodes/1/organs/2/kind: is a second bender, but a part has at most one");
    CHECK(complaint_after([](Organs& organs) { organs[0].parameters[0] = 4.0; }) ==
          "/nodes/1/organs/0/band: 4 is outside [0, 3] or not a whole number");
    CHECK(complaint_after([](Organs& organs) { organs[0].parameters[0] = 1.5; }) ==
          "/nodes/1/organs/0/band: 1.5 is outside [0, 3] or not a whole number");
    CHECK(complaint_after([](Organs& organs) { organs[1].parameters[0] = 1.0; }) ==
          "/nodes/1/organs/1: has a parameter that its kind does not use");
    CHECK(complaint_after([](Organs& organs) { organs[0].input.weight = 5.0; }) ==
          "/nodes/1/organs/0/w: 5 is outside [-4, 4]");
    CHECK(complaint_after([](Organs& organs) {
              organs[0].input.source.kind = SourceKind::kPartSensor;
          }) == "/nodes/1/organs/0/from/kind: is only for central neurons");
    CHECK(complaint_after([](Organs& organs) { organs.resize(4, {.kind = 1}); }) ==
          "/nodes/1/organs: 4 entries, allowed are 0 to 3");
}

TEST_CASE("validate finds unreachable nodes, bad targets and another order", "[genome][validate]") {
    Genome genome = two_parts();
    genome.nodes.emplace_back();
    CHECK(only_complaint(genome) == "/nodes: 1 cannot be reached from the root");
    genome.nodes[0].edges = {{.target = 2}, {.target = 1}};
    CHECK(only_complaint(genome) == "/nodes: are not in breadth-first order from the root");
    genome = two_parts();
    genome.nodes[1].edges = {{.target = 7}};
    CHECK(only_complaint(genome) == "/nodes/1/edges/0/target: 7, but there are 2 nodes");
}
