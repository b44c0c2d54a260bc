// Strokes of a pen in the hand of a child: every one must leave a valid genome that grows.

#include "core/random.h"
#include "genome/founders/random_genome.h"
#include "sketch/part_edits.h"
#include "sketch/rhythm.h"
#include "sketches.h"

namespace cambrian {
namespace {

Vec2 anywhere(RandomStream& stream) {
    return {stream.uniform(-2.5, 2.5), stream.uniform(-2.5, 2.5)};
}

// Returns the genome after one stroke, which is the same one if the stroke is refused.
Genome after_stroke(const BodySketch& sketch, RandomStream& stream) {
    const SketchRules rules = test::rules();
    const std::size_t part = stream.below(sketch.body.parts.size());
    const auto sides = static_cast<MirrorSides>(stream.below(3));
    const auto or_same = [&](Result<Genome> result) {
        return result ? *std::move(result) : sketch.genome;
    };
    switch (stream.below(part > 0 ? 9 : 6)) {
        case 0:
        case 1:
        case 2: {
            auto grown =
                grow_part(sketch, part, {anywhere(stream), anywhere(stream), sides}, rules);
            return grown ? std::move(grown->genome) : sketch.genome;
        }
        case 3:
            return drag_end(sketch, part, anywhere(stream));
        case 4:
            return drag_side(sketch, part, anywhere(stream));
        case 5:
            return stream.chance(0.5)
                       ? or_same(repeat_part(sketch, part, stream.between(0, 7), rules))
                       : or_same(with_rhythm(sketch,
                                             {stream.uniform(0.0, 5.0), stream.uniform(0.0, 4.0),
                                              stream.uniform(-2.0, 2.0)},
                                             rules));
        case 6:
            return slide_joint(sketch, part, anywhere(stream));
        case 7:
            return or_same(switch_pair(sketch, part, sides, rules));
        default:
            break;
    }
    return stream.chance(0.5) ? remove_part(sketch, part, rules) : sketch.genome;
}

void scribble(Genome genome, RandomStream& stream) {
    std::size_t most = 0;
    for (int stroke = 0; stroke < 200; ++stroke) {
        const BodySketch sketch = test::drawn(genome);
        REQUIRE(sketch.origins.size() == sketch.body.parts.size());
        most = std::max(most, sketch.body.parts.size());
        genome = after_stroke(sketch, stream);
        const auto faults = validate(genome, test::kind_catalog());
        INFO(stroke << ": " << (faults.empty() ? std::string() : faults.front()));
        REQUIRE(faults.empty());
    }
    CHECK(most > 3);
}

TEST_CASE("200 random strokes from one box always give a valid genome that grows",
          "[sketch][strokes]") {
    for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U}) {
        RandomStream stream(seed);
        scribble(first_part(), stream);
    }
}

TEST_CASE("so do 200 strokes from random creatures", "[sketch][strokes]") {
    FounderSettings founders;
    for (const std::uint64_t seed : {11U, 12U, 13U, 14U, 15U, 16U, 17U, 18U, 19U, 20U}) {
        RandomStream stream(seed);
        scribble(random_genome(founders, test::kind_catalog(), stream), stream);
    }
}

TEST_CASE("the edge of every part of a random creature is found", "[sketch][body_sketch]") {
    FounderSettings founders;
    RandomStream stream(3);
    std::size_t parts = 0;
    for (int i = 0; i < 2000; ++i) {
        const BodySketch sketch =
            test::drawn(random_genome(founders, test::kind_catalog(), stream));
        for (std::size_t part = 1; part < sketch.body.parts.size(); ++part)
            CHECK(sketch.edge_of(part).target == sketch.body.parts[part].node);
        parts += sketch.body.parts.size();
    }
    CHECK(parts > 5000);
}

}  // namespace
}  // namespace cambrian
