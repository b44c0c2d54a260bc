#include "studio/host/frame_pace.h"

#include <catch2/catch.hpp>

namespace cambrian {
namespace {

// Frames of 1/60 s that take so long to draw, in s.
void draw_for(FramePace& pace, double seconds, double drawing) {
    for (double time = 0.0; time < seconds; time += 1.0 / 60.0)
        pace.note(drawing, 1.0 / 60.0);
}

TEST_CASE("scenery becomes less while frames are slow", "[studio][pace]") {
    FramePace pace;
    CHECK(pace.tier() == Scenery::kFull);
    draw_for(pace, 60.0, 0.014);
    CHECK(pace.tier() == Scenery::kFull);
    draw_for(pace, 1.2, 0.016);
    CHECK(pace.tier() == Scenery::kFull);
    draw_for(pace, 0.5, 0.016);
    CHECK(pace.tier() == Scenery::kLight);
    draw_for(pace, 20.0, 0.029);
    CHECK(pace.tier() == Scenery::kLight);
    draw_for(pace, 2.0, 0.031);
    CHECK(pace.tier() == Scenery::kPlain);
    draw_for(pace, 9.0, 0.050);
    CHECK(pace.tier() == Scenery::kPlain);
}

TEST_CASE("scenery becomes more where frames leave room for it, at most twice", "[studio][pace]") {
    FramePace pace;
    draw_for(pace, 4.0, 0.031);
    REQUIRE(pace.tier() == Scenery::kPlain);
    draw_for(pace, 9.0, 0.004);
    CHECK(pace.tier() == Scenery::kPlain);
    draw_for(pace, 2.0, 0.004);
    CHECK(pace.tier() == Scenery::kLight);
    draw_for(pace, 11.0, 0.004);
    CHECK(pace.tier() == Scenery::kFull);
    draw_for(pace, 2.0, 0.016);
    CHECK(pace.tier() == Scenery::kLight);
    draw_for(pace, 60.0, 0.004);
    CHECK(pace.tier() == Scenery::kLight);
}

TEST_CASE("a few slow frames change nothing", "[studio][pace]") {
    FramePace pace;
    for (int i = 0; i < 6000; ++i)
        pace.note(i % 3 == 0 ? 0.2 : 0.008, i % 3 == 0 ? 0.2 : 1.0 / 60.0);
    CHECK(pace.tier() == Scenery::kFull);
}

}  // namespace
}  // namespace cambrian
