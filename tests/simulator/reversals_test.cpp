#include "simulator/reversals.h"

#include "support/catch.h"

#include <cmath>

using namespace cambrian;

namespace {

int reversals_of_sine(double amplitude, double frequency, double seconds) {
    ReversalCounter counter(0.0);
    for (int tick = 1; tick <= static_cast<int>(60 * seconds); ++tick) {
        counter.watch(amplitude * std::sin(2 * 3.14159265358979 * frequency * tick / 60.0));
    }
    return counter.count();
}

}  // namespace

TEST_CASE("a joint swinging at f Hz reverses 2 f times a second", "[simulator][reversals]") {
    CHECK(reversals_of_sine(0.5, 1.0, 10.0) == 20);
    CHECK(reversals_of_sine(0.5, 7.0, 10.0) == 140);
}

TEST_CASE("swings below 0.05 rad do not count", "[simulator][reversals]") {
    CHECK(reversals_of_sine(0.02, 10.0, 10.0) == 0);
    CHECK(reversals_of_sine(0.03, 5.0, 10.0) > 0);  // an amplitude of 0.03 rad
}

TEST_CASE("a joint that only turns one way never reverses", "[simulator][reversals]") {
    ReversalCounter counter(0.0);
    for (int tick = 1; tick < 1000; ++tick)
        counter.watch(0.1 * tick);
    CHECK(counter.count() == 0);
}
