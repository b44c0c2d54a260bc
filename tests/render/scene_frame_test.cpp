#include "render/scene_frame.h"

#include "support/catch.h"

namespace cambrian {
namespace {

TEST_CASE("a line reaches from end to end, with round caps", "[render][scene_frame]") {
    SceneFrame frame;
    frame.add_line({0.0, 0.0}, {3.0, 4.0}, 0.2, color_of(0xFFFFFF));
    REQUIRE(frame.shapes.size() == 1);
    const Shape& line = frame.shapes.front();
    CHECK((line.center - Vec2(1.5, 2.0)).norm() < 1e-12);
    CHECK(line.half_extents.x() == Approx(2.6));
    CHECK(line.half_extents.y() == Approx(0.1));
    CHECK(line.radius == Approx(0.1));
}

TEST_CASE("a ring is empty inside", "[render][scene_frame]") {
    SceneFrame frame;
    frame.add_ring({1.0, 1.0}, 0.5, 0.05, color_of(0x00FF00));
    CHECK(frame.shapes.front().fill.a == 0.0F);
    CHECK(frame.shapes.front().outline.a == 1.0F);
}

TEST_CASE("an arc keeps to its ring and begins and ends at its angles", "[render][scene_frame]") {
    SceneFrame frame;
    frame.add_arc({1.0, 2.0}, 0.5, {0.0, -1.5}, 0.0, color_of(0xFFFFFF));
    REQUIRE(frame.shapes.size() > 4);
    for (const Shape& shape : frame.shapes) {
        CHECK((shape.center - Vec2(1.0, 2.0)).norm() == Approx(0.5).epsilon(0.01));
        CHECK(shape.center.y() < 2.0);
    }
    const Shape& first = frame.shapes.front();
    CHECK((first.center - Vec2(1.5, 2.0)).norm() == Approx(first.half_extents.x()));
}

TEST_CASE("a trail is fainter the older it is", "[render][scene_frame]") {
    SceneFrame frame;
    const std::vector<Vec2> points = {{0.0, 0.0}, {1.0, 0.0}, {2.0, 0.0}, {3.0, 0.0}};
    frame.add_trail(points, 0.02, color_of(0xFFFFFF));
    REQUIRE(frame.shapes.size() == 4);
    for (std::size_t i = 1; i < frame.shapes.size(); ++i)
        CHECK(frame.shapes[i].fill.a > frame.shapes[i - 1].fill.a);
}

TEST_CASE("a cleared frame shows nothing of the one before", "[render]") {
    const BackdropRecipe recipe;
    SceneFrame frame;
    frame.backdrop = &recipe;
    frame.light.lamp_power = 1.0F;
    frame.add_circle(Vec2::Zero(), 1.0, color_of(0xFFFFFF));
    frame.skin_boxes.emplace_back();
    Skin skin;
    skin.boxes = 1;
    frame.add_skin(skin);
    frame.clear();
    CHECK(frame.backdrop == nullptr);
    CHECK(frame.light.lamp_power == 0.0F);
    CHECK(frame.shapes.empty());
    CHECK(frame.skins.empty());
    CHECK(frame.skin_boxes.empty());
}

}  // namespace
}  // namespace cambrian
