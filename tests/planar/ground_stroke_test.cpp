// Ground that is drawn by hand.
#include "world/ground_stroke.h"

#include "core/random.h"
#include "support/catch.h"

#include <string>
#include <vector>

using namespace cambrian;

namespace {

std::string drawn(const std::vector<GroundPoint>& stroke, const TerrainSettings& before = {},
                  bool straight = false) {
    const auto terrain = with_stroke(before, snapped_stroke(stroke, straight));
    REQUIRE(terrain);
    CHECK(terrain->kind == "drawn");
    return terrain->points;
}

}  // namespace

TEST_CASE("a stroke replaces the profile between its ends", "[world][stroke]") {
    const std::vector<GroundPoint> ramp = {{2.01, 0.02}, {3.0, 0.52}, {4.02, 1.0}};
    CHECK(drawn(ramp) == "-40 0; 2 0; 4 1; 4 0; 40 0");
    CHECK(drawn({ramp.rbegin(), ramp.rend()}) == drawn(ramp));
    CHECK(drawn({{2.0, 0.0}, {2.6, 3.0}, {4.0, 1.0}}, {}, true) == drawn(ramp));
    const TerrainSettings before{.kind = "drawn", .points = drawn(ramp)};
    CHECK(drawn({{3.0, 0.5}, {3.5, 0.5}, {6.0, 0.5}}, before) ==
          "-40 0; 2 0; 3 0.5; 6 0.5; 6 0; 40 0");
    CHECK(drawn({{50.0, 0.0}, {60.0, 2.0}}, before) ==
          "-40 0; 2 0; 4 1; 4 0; 40 0; 50 0; 60 2; 60 0");
}

TEST_CASE("a stroke through ground that was made keeps the rest of it", "[world][stroke]") {
    const TerrainSettings stairs{.kind = "stairs", .height = 0.1, .spacing = 1.0};
    const auto terrain = with_stroke(
        stairs, snapped_stroke(std::vector<GroundPoint>{{-1.0, 0.5}, {1.0, 0.5}}, false));
    REQUIRE(terrain);
    const auto before = Terrain::make(stairs);
    const auto after = Terrain::make(*terrain);
    REQUIRE((before && after));
    for (const double x : {-20.3, -5.3, -1.2, 1.2, 7.7, 33.1})
        CHECK((*after)->height(x) == Approx((*before)->height(x)));
    for (const double x : {-0.9, 0.0, 0.9})
        CHECK((*after)->height(x) == Approx(0.5));
}

TEST_CASE("a click and a line straight up are no strokes", "[world][stroke]") {
    CHECK(snapped_stroke(std::vector<GroundPoint>{{1.0, 0.0}}, false).empty());
    CHECK(snapped_stroke(std::vector<GroundPoint>{{1.0, 0.0}, {1.0, 2.0}}, false).empty());
    CHECK(snapped_stroke({}, false).empty());
}

TEST_CASE("scribbles become ground, nearly always, and never anything else", "[world][stroke]") {
    RandomStream stream(7);
    int refused = 0;
    TerrainSettings terrain;
    for (int scribble = 0; scribble < 200; ++scribble) {
        std::vector<GroundPoint> stroke = {{stream.uniform(-9.0, 9.0), stream.uniform(-0.5, 1.0)}};
        for (int i = 0; i < 60; ++i) {
            const double x = stroke.back().x + stream.uniform(-0.05, 0.15);
            stroke.push_back({x, stroke.back().y + stream.uniform(-0.2, 0.2)});
        }
        const auto points = snapped_stroke(stroke, false);
        if (points.empty()) continue;
        const auto after = with_stroke(terrain, points);
        refused += after ? 0 : 1;
        if (!after) UNSCOPED_INFO(after.error().message);
        if (!after) continue;
        CHECK(check_ground_points(after->points));
        terrain = *after;
    }
    CHECK(refused <= 4);
}
