#include "math/reflect.h"

#include "core/random.h"
#include "support/catch.h"

using namespace cambrian;

TEST_CASE("a value inside the bounds is left as it is", "[math][reflect]") {
    RandomStream stream(31);
    for (int i = 0; i < 10000; ++i) {
        const double x = stream.uniform(0.08, 1.6);
        REQUIRE(reflect(x, 0.08, 1.6) == Approx(x).epsilon(1e-15));
    }
    CHECK(reflect(0.08, 0.08, 1.6) == 0.08);
    CHECK(reflect(1.6, 0.08, 1.6) == 1.6);
}

TEST_CASE("a value beyond a bound is mirrored back at it", "[math][reflect]") {
    CHECK(reflect(1.25, 0.0, 1.0) == Approx(0.75));
    CHECK(reflect(-0.25, 0.0, 1.0) == Approx(0.25));
    CHECK(reflect(2.25, 0.0, 1.0) == Approx(0.25));
    CHECK(reflect(-7.5, -2.0, 2.0) == Approx(0.5));
}

TEST_CASE("a reflected value is inside the bounds however far it was out", "[math][reflect]") {
    RandomStream stream(32);
    for (int i = 0; i < 100000; ++i) {
        const double low = stream.uniform(-3.0, 3.0);
        const double high = low + stream.uniform(1e-9, 4.0);
        const double inside = reflect(stream.uniform(-1e6, 1e6), low, high);
        REQUIRE(inside >= low);
        REQUIRE(inside <= high);
    }
}

TEST_CASE("between equal bounds there is only one value", "[math][reflect]") {
    CHECK(reflect(17.0, 0.5, 0.5) == 0.5);
}
