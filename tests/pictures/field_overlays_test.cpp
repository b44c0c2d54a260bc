// Overlays of sounds and scent: what is drawn, and where.
#include "pictures/scene/field_overlays.h"

#include "support/catch.h"

#include <algorithm>
#include <array>
#include <cmath>

using namespace cambrian;

namespace {

constexpr Viewport kWindow{800, 600};

Camera close_camera() {
    Camera camera;
    camera.pixels_per_metre = 100.0;
    return camera;
}

double opacity_at(const SceneFrame& frame, const Vec2& point) {
    double opacity = 0.0;
    for (const Shape& shape : frame.shapes) {
        const Vec2 away = (point - shape.center).cwiseAbs();
        if (away.x() < shape.half_extents.x() && away.y() < shape.half_extents.y())
            opacity = std::max(opacity, static_cast<double>(shape.fill.a));
    }
    return opacity;
}

}  // namespace

TEST_CASE("rings are where a listener reads a half, a quarter and an eighth", "[pictures]") {
    SceneFrame frame;
    const std::array sounds = {Sound{{1.0, 2.0, 0.0}, 0, 1.0}, Sound{{0.0, 0.0, 0.0}, 3, 0.3},
                               Sound{{0.0, 0.0, 0.0}, 1, 0.0}};
    add_sounds(frame, close_camera(), sounds);
    // A dot and three rings; a dot, and the rings of a quarter and an eighth; nothing.
    REQUIRE(frame.shapes.size() == 7);
    for (std::size_t i = 1; i < 4; ++i) {
        const double heard = std::pow(0.5, static_cast<double>(i));
        CHECK(1.0 / (1.0 + frame.shapes[i].radius) == Approx(heard));
        CHECK(frame.shapes[i].center == Vec2(1.0, 2.0));
        CHECK(frame.shapes[i].fill.a == 0.0F);
    }
    CHECK(0.3 / (1.0 + frame.shapes[5].radius) == Approx(0.25));
    CHECK(frame.shapes[0].fill != frame.shapes[4].fill);
}

TEST_CASE("scent is tinted more strongly where there is more", "[pictures]") {
    ScentField field({.left = -10.0, .bottom = -10.0, .columns = 40, .rows = 40});
    SceneFrame frame;
    add_scent(frame, close_camera(), kWindow, field);
    CHECK(frame.shapes.empty());
    field.add({1.0, 1.0, 0.0}, 0.05);
    for (int i = 0; i < 20; ++i)
        field.step();
    add_scent(frame, close_camera(), kWindow, field);
    CHECK(opacity_at(frame, {1.01, 1.01}) > opacity_at(frame, {2.01, 1.01}));
    CHECK(opacity_at(frame, {2.01, 1.01}) > 0.0);
    CHECK(opacity_at(frame, {-3.49, -2.49}) == 0.0);
    for (const Shape& shape : frame.shapes)
        CHECK(std::fabs(shape.center.x()) < 4.6);  // 8 m are in view
}
