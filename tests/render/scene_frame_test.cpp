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

TEST_CASE("a trail is fainter the older it is", "[render][scene_frame]") {
    SceneFrame frame;
    frame.add_trail({{0.0, 0.0}, {1.0, 0.0}, {2.0, 0.0}, {3.0, 0.0}}, 0.02, color_of(0xFFFFFF));
    REQUIRE(frame.shapes.size() == 4);
    for (std::size_t i = 1; i < frame.shapes.size(); ++i)
        CHECK(frame.shapes[i].fill.a > frame.shapes[i - 1].fill.a);
}

}  // namespace
}  // namespace cambrian
