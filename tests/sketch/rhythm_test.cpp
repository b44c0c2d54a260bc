#include "sketch/rhythm.h"

#include "creature/creature.h"
#include "sketches.h"
#include "support/creatures.h"

namespace cambrian {
namespace {

using test::check_valid;
using test::drawn;
using test::grown;

BodySketch tail_of_three() {
    BodySketch sketch = drawn(first_part());
    std::size_t last = 0;
    for (int i = 0; i < 3; ++i) {
        const Vec2 end = test::far_end(sketch, last);
        sketch = drawn(grown(sketch, last, end, end + Vec2(0.3, 0.0)));
        last = sketch.body.parts.size() - 1;
    }
    return sketch;
}

TEST_CASE("a rhythm drives every joint, one after the other along the body", "[sketch][rhythm]") {
    const BodySketch sketch = tail_of_three();
    const Rhythm rhythm{1.5, 0.5, 0.9};
    const auto genome = with_rhythm(sketch, rhythm, test::rules());
    REQUIRE(genome);
    check_valid(*genome);
    const BodySketch moving = drawn(*genome);
    CHECK(moving.body.has_live_control);
    for (std::size_t part = 1; part < 4; ++part) {
        const NodeGene& node = moving.node_of(part);
        REQUIRE(node.neurons.size() == 1);
        CHECK(node.effector.weight == 0.5);
        CHECK(node.neurons[0].inputs[0].weight == 1.5);
        const double phase = 0.3 * static_cast<double>(part - 1);  // 0.6 is as far behind as -0.4
        CHECK(node.neurons[0].inputs[1].weight ==
              Approx(phase < 0.5 ? phase : phase - 1.0).margin(1e-12));
    }
    const auto read = rhythm_of(moving, test::rules());
    REQUIRE(read);
    CHECK(read->frequency == 1.5);
    CHECK(read->swing == 0.5);
    CHECK(read->wave == Approx(0.9));
}

TEST_CASE("another rhythm changes the neurons that the first one added", "[sketch][rhythm]") {
    const BodySketch sketch = tail_of_three();
    const auto first = with_rhythm(sketch, {1.0, 0.5, 1.0}, test::rules());
    REQUIRE(first);
    const auto second = with_rhythm(drawn(*first), {99.0, 99.0, -0.5}, test::rules());
    REQUIRE(second);
    check_valid(*second);
    CHECK(second->nodes[1].neurons.size() == 1);
    CHECK(second->nodes[1].neurons[0].inputs[0].weight == kMostFrequency);
    CHECK(second->nodes[1].effector.weight == kMostRhythmSwing);
}

TEST_CASE("joints whose sines are out of step have no rhythm", "[sketch][rhythm]") {
    const auto genome = with_rhythm(tail_of_three(), {1.5, 0.5, 0.9}, test::rules());
    REQUIRE(genome);
    Genome uneven = *genome;
    uneven.nodes[2].neurons[0].inputs[1].weight += 0.1;
    CHECK_FALSE(rhythm_of(drawn(uneven), test::rules()));
    Genome faster = *genome;
    faster.nodes[3].neurons[0].inputs[0].weight *= 2.0;
    CHECK_FALSE(rhythm_of(drawn(faster), test::rules()));
}

TEST_CASE("two legs alternate", "[sketch][rhythm]") {
    BodySketch sketch = test::body_with_leg();
    sketch = drawn(grown(sketch, 0, {-0.25, -0.11}, {-0.3, -0.5}));
    const auto genome = with_rhythm(sketch, {}, test::rules());
    REQUIRE(genome);
    const double phases =
        genome->nodes[1].neurons[0].inputs[1].weight - genome->nodes[2].neurons[0].inputs[1].weight;
    CHECK(std::fabs(phases) == 0.5);
    const auto read = rhythm_of(drawn(*genome), test::rules());
    REQUIRE(read);
    CHECK(read->wave == 1.0);
}

TEST_CASE("a body without joints has no rhythm", "[sketch][rhythm]") {
    const BodySketch box = drawn(first_part());
    CHECK_FALSE(rhythm_of(box, test::rules()));
    const auto none = with_rhythm(box, {}, test::rules());
    REQUIRE_FALSE(none);
    CHECK(none.error().message.find("needs a joint") != std::string::npos);
    CHECK_FALSE(rhythm_of(tail_of_three(), test::rules()));
}

TEST_CASE("a rhythm of a creature with a brain keeps within its room for neurons",
          "[sketch][rhythm]") {
    Genome genome = *test::crawler(test::kind_catalog());
    for (NodeGene& node : genome.nodes)
        while (node.neurons.size() < gene_range::kMaxNodeNeurons)
            node.neurons.push_back({0, std::vector<InputGene>(static_cast<std::size_t>(
                                           test::kind_catalog().functions[0].arity))});
    genome.nodes[1].effector.source = {};
    check_valid(genome);
    const auto full = with_rhythm(drawn(genome), {}, test::rules());
    REQUIRE(full);
    check_valid(*full);
    CHECK(rhythm_of(drawn(*full), test::rules()));
}

}  // namespace
}  // namespace cambrian
