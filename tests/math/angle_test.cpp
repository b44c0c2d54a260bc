#include "math/angle.h"

#include "core/random.h"
#include "support/catch.h"

#include <cmath>

using namespace cambrian;

TEST_CASE("a wrapped angle lies from -pi up to below pi and points the same way", "[math][angle]") {
    RandomStream stream(21);
    for (int i = 0; i < 100000; ++i) {
        const double angle = stream.uniform(-1e4, 1e4);
        const double wrapped = wrap_angle(angle);
        REQUIRE(wrapped >= -kPi);
        REQUIRE(wrapped < kPi);
        REQUIRE(std::sin(wrapped) == Approx(std::sin(angle)).margin(1e-11));
        REQUIRE(std::cos(wrapped) == Approx(std::cos(angle)).margin(1e-11));
    }
}

TEST_CASE("angles beside half a turn wrap to the inside", "[math][angle]") {
    for (int turns = -50; turns <= 50; ++turns) {
        const double edge = (2 * turns + 1) * kPi;
        for (const double angle : {edge, std::nextafter(edge, -1e9), std::nextafter(edge, 1e9)}) {
            CHECK(wrap_angle(angle) >= -kPi);
            CHECK(wrap_angle(angle) < kPi);
        }
    }
    CHECK(wrap_angle(kPi) == -kPi);
    CHECK(wrap_angle(-kPi) == -kPi);
    CHECK(wrap_angle(0.5) == 0.5);
}

TEST_CASE("degrees and radians convert both ways", "[math][angle]") {
    CHECK(to_degrees(kPi) == Approx(180.0));
    CHECK(to_radians(-90.0) == Approx(-kPi / 2));
    CHECK(to_radians(to_degrees(1.25)) == Approx(1.25));
}

TEST_CASE("sine and cosine of quarter turns in degrees are exact", "[math][angle]") {
    const double sines[] = {0.0, 1.0, 0.0, -1.0};
    for (int quarter = -9; quarter <= 9; ++quarter) {
        const SineCosine turn = sine_cosine_of_degrees(90.0 * quarter);
        CHECK(turn.sine == sines[(quarter + 12) % 4]);
        CHECK(turn.cosine == sines[(quarter + 13) % 4]);
    }
    for (double degrees = -400.0; degrees < 400.0; degrees += 7.3) {
        const SineCosine turn = sine_cosine_of_degrees(degrees);
        CHECK(turn.sine == Approx(std::sin(to_radians(degrees))).margin(1e-13));
        CHECK(turn.cosine == Approx(std::cos(to_radians(degrees))).margin(1e-13));
    }
}
