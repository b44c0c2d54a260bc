#include "sketch/part_edits.h"

#include "sketches.h"

namespace cambrian {
namespace {

using test::check_valid;
using test::drawn;
using test::grown;

TEST_CASE("a removed part goes with what grows from it and with its image",
          "[sketch][part_edits]") {
    BodySketch sketch =
        drawn(grown(drawn(first_part()), 0, {0.25, -0.11}, {0.3, -0.5}, MirrorSides::kSideways));
    sketch = drawn(grown(sketch, 1, {0.3, -0.5}, {0.35, -0.8}));
    REQUIRE(sketch.body.parts.size() == 5);
    const Genome without_feet = remove_part(sketch, 3, test::rules());
    check_valid(without_feet);
    CHECK(drawn(without_feet).body.parts.size() == 3);
    const Genome bare = remove_part(sketch, 2, test::rules());
    check_valid(bare);
    CHECK(bare.nodes.size() == 1);
    CHECK(drawn(bare).body.parts.size() == 1);
}

TEST_CASE("a part repeats in a row, and what is at its end grows at the last one",
          "[sketch][part_edits]") {
    BodySketch sketch = test::body_with_leg();
    sketch = drawn(grown(sketch, 1, test::far_end(sketch, 1), {0.5, -0.6}));
    REQUIRE(sketch.body.parts.size() == 3);
    const auto three = repeat_part(sketch, 1, 3, test::rules());
    REQUIRE(three);
    check_valid(*three);
    const BodySketch chain = drawn(*three);
    CHECK(chain.body.parts.size() == 5);  // the body, three links, the foot
    CHECK(repeats_of(chain, 1) == 3);
    // Without the third link, and then without any.
    const BodySketch two = drawn(remove_part(chain, 3, test::rules()));
    CHECK(two.body.parts.size() == 4);
    CHECK(repeats_of(two, 1) == 2);
    const auto one = repeat_part(two, 1, 1, test::rules());
    REQUIRE(one);
    CHECK(*one == sketch.genome);
    CHECK(repeats_of(drawn(*one), 1) == 1);
}

TEST_CASE("the root repeats with its legs", "[sketch][part_edits]") {
    const auto centipede = repeat_part(test::body_with_leg(), 0, 4, test::rules());
    REQUIRE(centipede);
    CHECK(drawn(*centipede).body.parts.size() == 8);
}

TEST_CASE("a part gets an image and loses it, whichever of the two is kept",
          "[sketch][part_edits]") {
    const BodySketch sketch = test::body_with_leg();
    const auto paired = switch_pair(sketch, 1, MirrorSides::kSideways, test::rules());
    REQUIRE(paired);
    check_valid(*paired);
    const BodySketch two = drawn(*paired);
    REQUIRE(two.body.parts.size() == 3);
    CHECK(is_paired(two, 2));
    const auto left = switch_pair(two, 2, MirrorSides::kSideways, test::rules());
    REQUIRE(left);
    check_valid(*left);
    const BodySketch alone = drawn(*left);
    REQUIRE(alone.body.parts.size() == 2);
    CHECK((test::far_end(alone, 1) - Vec2(-0.3, -0.5)).norm() < 1e-9);
    CHECK(alone.body.parts[1].mirror.across == two.body.parts[2].mirror.across);
    const auto right = switch_pair(two, 1, MirrorSides::kSideways, test::rules());
    REQUIRE(right);
    CHECK((test::far_end(drawn(*right), 1) - Vec2(0.3, -0.5)).norm() < 1e-9);
}

TEST_CASE("a part on the axis gets no image and the reason is told", "[sketch][part_edits]") {
    const BodySketch tail = drawn(grown(drawn(first_part()), 0, {0.0, -0.11}, {0.0, -0.5}));
    const auto image = switch_pair(tail, 1, MirrorSides::kSideways, test::rules());
    REQUIRE_FALSE(image);
    CHECK(image.error().message.find("move it aside") != std::string::npos);
}

TEST_CASE("a part is found again by its name after others changed", "[sketch][part_edits]") {
    BodySketch sketch = test::body_with_leg();
    sketch = drawn(grown(sketch, 0, {-0.25, -0.11}, {-0.3, -0.5}));
    const PartName second = name_of(sketch, 2);
    const BodySketch fewer = drawn(remove_part(sketch, 1, test::rules()));
    CHECK(find_part(fewer, second) == 1);
    CHECK_FALSE(find_part(fewer, name_of(sketch, 1)));
}

}  // namespace
}  // namespace cambrian
