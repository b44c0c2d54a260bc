#include "sketch/strokes.h"

#include "math/angle.h"
#include "persist/creature/creature_file.h"
#include "sketch/pairs.h"
#include "sketches.h"

#include <filesystem>

namespace cambrian {
namespace {

using test::check_valid;
using test::drawn;
using test::grown;

TEST_CASE("a new part begins at the outline and ends where the pen was", "[sketch][strokes]") {
    const BodySketch sketch = test::body_with_leg();
    REQUIRE(sketch.body.parts.size() == 2);
    CHECK(joint_place(sketch, 1).y() == Approx(-0.11));
    CHECK(joint_place(sketch, 1).x() == Approx(0.25));
    CHECK((test::far_end(sketch, 1) - Vec2(0.3, -0.5)).norm() < 1e-9);
    CHECK(sketch.body.effectors.size() == 1);
    // It hangs still until it gets a signal.
    CHECK(sketch.node_of(1).effector.weight == 0.0);
    CHECK(sketch.node_of(1).limit_high == Approx(to_radians(60.0)));
}

TEST_CASE("the length and the direction of a new part stay in their ranges", "[sketch][strokes]") {
    const BodySketch body = drawn(first_part());
    const BodySketch longest = drawn(grown(body, 0, {0.0, -0.11}, {0.0, -9.0}));
    CHECK(longest.node_of(1).length == gene_range::kMaxLength);
    const BodySketch shortest = drawn(grown(body, 0, {0.0, -0.11}, {0.0, -0.12}));
    CHECK(shortest.node_of(1).length == gene_range::kMinSize);
    // Backwards into the body is as far to a side as is possible.
    const BodySketch inward = drawn(grown(body, 0, {0.0, -0.11}, {0.3, 0.5}));
    CHECK(std::fabs(inward.edge_of(1).angle) == gene_range::kMaxEdgeAngle);
}

TEST_CASE("mirrored parts are left and right, or above and below, as seen", "[sketch][strokes]") {
    const BodySketch body = drawn(first_part());
    const BodySketch legs =
        drawn(grown(body, 0, {0.25, -0.11}, {0.3, -0.5}, MirrorSides::kSideways));
    REQUIRE(legs.body.parts.size() == 3);
    CHECK((test::far_end(legs, 1) - Vec2(0.3, -0.5)).norm() < 1e-9);
    CHECK((test::far_end(legs, 2) - Vec2(-0.3, -0.5)).norm() < 1e-9);
    const BodySketch fins =
        drawn(grown(body, 0, {0.25, -0.11}, {0.3, -0.5}, MirrorSides::kUpright));
    REQUIRE(fins.body.parts.size() == 3);
    CHECK((test::far_end(fins, 2) - Vec2(0.3, 0.5)).norm() < 1e-9);
    Genome upright = first_part();
    upright.root_angle = 0.5 * kPi;
    const BodySketch arms =
        drawn(grown(drawn(upright), 0, {0.11, 0.2}, {0.5, 0.3}, MirrorSides::kSideways));
    REQUIRE(arms.body.parts.size() == 3);
    CHECK((test::far_end(arms, 2) - Vec2(-0.5, 0.3)).norm() < 1e-9);
}

TEST_CASE("a shin of a pair of legs grows at both and has no images of its own",
          "[sketch][strokes]") {
    BodySketch legs =
        drawn(grown(drawn(first_part()), 0, {0.25, -0.11}, {0.3, -0.5}, MirrorSides::kSideways));
    CHECK_FALSE(is_on_both_sides(legs, 0));
    CHECK(is_on_both_sides(legs, 2));
    legs = drawn(grown(legs, 2, {-0.3, -0.5}, {-0.25, -0.9}, MirrorSides::kSideways));
    REQUIRE(legs.body.parts.size() == 5);
    CHECK((test::far_end(legs, 4) - Vec2(-0.25, -0.9)).norm() < 1e-9);
    CHECK((test::far_end(legs, 3) - Vec2(0.25, -0.9)).norm() < 1e-9);
}

TEST_CASE("a part on the mirror's axis stays alone", "[sketch][strokes]") {
    const BodySketch body = drawn(first_part());
    const BodySketch tail =
        drawn(grown(body, 0, {0.0, -0.11}, {0.0, -0.5}, MirrorSides::kSideways));
    CHECK(tail.body.parts.size() == 2);
    CHECK_FALSE(tail.node_of(1).symmetric);
}

TEST_CASE("the far end of a part follows the pen, of an image, too", "[sketch][strokes]") {
    const BodySketch body = drawn(first_part());
    const BodySketch legs =
        drawn(grown(body, 0, {0.25, -0.11}, {0.3, -0.5}, MirrorSides::kSideways));
    const BodySketch moved = drawn(drag_end(legs, 2, {-0.5, -0.6}));
    check_valid(moved.genome);
    CHECK((test::far_end(moved, 2) - Vec2(-0.5, -0.6)).norm() < 1e-9);
    CHECK((test::far_end(moved, 1) - Vec2(0.5, -0.6)).norm() < 1e-9);
    CHECK((joint_place(moved, 2) - joint_place(legs, 2)).norm() < 1e-12);
}

TEST_CASE("the root turns about its middle", "[sketch][strokes]") {
    const BodySketch body = drawn(drag_end(drawn(first_part()), 0, {0.0, 0.5}));
    CHECK((test::far_end(body, 0) - Vec2(0.0, 0.5)).norm() < 1e-9);
    CHECK(body.body.plan.parts[0].rest_pose.position.norm() == 0.0);
    check_valid(drag_end(body, 0, {0.0, 0.0}));
}

TEST_CASE("a side follows the pen and a joint slides along the outline", "[sketch][strokes]") {
    const BodySketch sketch = test::body_with_leg();
    const BodySketch wide = drawn(drag_side(sketch, 0, {0.1, 0.2}));
    CHECK(wide.node_of(0).width == Approx(0.4));
    const BodySketch slid = drawn(slide_joint(sketch, 1, {-0.2, -0.3}));
    CHECK((joint_place(slid, 1) - Vec2(-0.2, -0.11)).norm() < 1e-9);
    CHECK(slid.edge_of(1).angle == sketch.edge_of(1).angle);
    const BodySketch behind = drawn(slide_joint(sketch, 1, {-0.9, 0.0}));
    CHECK((joint_place(behind, 1) - Vec2(-0.35, 0.0)).norm() < 1e-9);
    check_valid(drag_side(sketch, 1, {9.0, 9.0}));
}

TEST_CASE("a body without room for a part says so", "[sketch][strokes]") {
    BodySketch sketch = drawn(first_part());
    for (int i = 0; i < 6; ++i) {
        const double x = -0.3 + 0.12 * i;
        sketch = drawn(grown(sketch, 0, {x, -0.11}, {x, -0.4}));
    }
    const NewPart seventh{{0.2, 0.11}, {0.2, 0.5}, MirrorSides::kNone};
    const auto full = grow_part(sketch, 0, seventh, test::rules());
    REQUIRE_FALSE(full);
    CHECK(full.error().message == "a part carries at most 6 others");
    ExpressionSettings small;
    small.max_parts = 3;
    const SketchRules few{test::creature_kinds(), small, test::kScene};
    const BodySketch three = sketch_of(sketch.genome, few);
    const auto most = grow_part(three, 1, seventh, few);
    REQUIRE_FALSE(most);
    CHECK(most.error().message.find("at most 3 parts") != std::string::npos);
}

// Draws a body anew, part after part, as a person would copy it. Numbers of genes may differ.
BodySketch copied(const BodySketch& model) {
    BodySketch copy = drawn(first_part());
    copy = drawn(drag_end(copy, 0, test::far_end(model, 0)));
    copy = drawn(drag_side(
        copy, 0,
        in_world(model.body.plan.parts[0], {0.0, model.body.plan.parts[0].half_extents.y()})));
    std::vector<PartName> names = {name_of(copy, 0)};
    for (std::size_t part = 1; part < model.body.parts.size(); ++part) {
        const auto parent = find_part(copy, names[model.parent_of(part)]);
        REQUIRE(parent);
        const auto stroke = grow_part(
            copy, *parent, {joint_place(model, part), test::far_end(model, part)}, test::rules());
        INFO(part << (stroke ? "" : stroke.error().message));
        REQUIRE(stroke);
        copy = drawn(stroke->genome);
        names.push_back(stroke->name);
        const auto at = find_part(copy, stroke->name);
        REQUIRE(at);
        const PlannedPart& planned = model.body.plan.parts[part];
        copy = drawn(drag_side(copy, *at, in_world(planned, {0.0, planned.half_extents.y()})));
    }
    return copy;
}

TEST_CASE("strokes make the bodies of the samples", "[sketch][strokes]") {
    int bodies = 0;
    const auto folder = std::filesystem::path(CAMBRIAN_SOURCE_DIR) / "assets/creatures";
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const auto document = load_creature(entry.path(), test::kinds());
        INFO(entry.path().string());
        REQUIRE(document);
        const BodySketch model = drawn(*document->creature.individual->genome);
        const BodySketch copy = copied(model);
        REQUIRE(copy.body.parts.size() == model.body.parts.size());
        // The order of growth may differ.
        for (std::size_t i = 0; i < model.body.parts.size(); ++i) {
            double nearest = 1.0;
            for (std::size_t j = 0; j < copy.body.parts.size(); ++j) {
                const double apart =
                    (test::far_end(model, i) - test::far_end(copy, j)).norm() +
                    (model.body.plan.parts[i].half_extents - copy.body.plan.parts[j].half_extents)
                        .norm();
                nearest = std::min(nearest, apart);
            }
            CHECK(nearest < 1e-3);
        }
        ++bodies;
    }
    CHECK(bodies > 10);
}

}  // namespace
}  // namespace cambrian
