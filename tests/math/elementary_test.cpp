#include "math/elementary.h"

#include "core/hash.h"
#include "core/random.h"
#include "support/catch.h"

#include <cmath>
#include <limits>

using namespace cambrian;

namespace {

constexpr int kPoints = 200000;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

using Function = double (*)(double);
using Reference = long double (*)(long double);

// The largest errors against libm in long double, over random points and points near 0.
struct Errors {
    long double absolute = 0;
    long double relative = 0;
};

Errors errors_of(Function function, Reference reference, double low, double high) {
    RandomStream stream(11);
    Errors errors;
    for (int i = 0; i < kPoints; ++i) {
        const double x = stream.uniform(low, high);
        const long double exact = reference(static_cast<long double>(x));
        const long double error = std::fabs(static_cast<long double>(function(x)) - exact);
        errors.absolute = std::fmax(errors.absolute, error);
        if (exact != 0) errors.relative = std::fmax(errors.relative, error / std::fabs(exact));
    }
    return errors;
}

long double exact_sine(long double x) {
    return std::sin(x);
}
long double exact_cosine(long double x) {
    return std::cos(x);
}
long double exact_arc_tangent(long double x) {
    return std::atan(x);
}
long double exact_exponential(long double x) {
    return std::exp(x);
}
long double exact_logarithm(long double x) {
    return std::log(x);
}

// Returns the hash of a function's bits over a grid.
std::uint64_t bits_of(Function function, double low, double high) {
    Hash64 hash;
    for (int i = 0; i <= 10000; ++i)
        hash.add(function(low + (high - low) * i / 10000));
    return hash.value();
}

}  // namespace

TEST_CASE("sine and cosine are exact to 2e-16 up to a million radians", "[math][elementary]") {
    for (const double reach : {0.8, 7.0, 1000.0, 1e6}) {
        CHECK(errors_of(sine, exact_sine, -reach, reach).absolute < 2e-16L);
        CHECK(errors_of(cosine, exact_cosine, -reach, reach).absolute < 2e-16L);
    }
}

TEST_CASE("sine and cosine alone have the bits of both together", "[math][elementary]") {
    RandomStream random(12);
    for (const double reach : {1e-300, 1e-8, 1.0, 4.0, 1e3, 1e6, 1e9, 1e300}) {
        for (int i = 0; i < 20'000; ++i) {
            const double x = random.uniform(-reach, reach);
            const SineCosine both = sine_cosine(x);
            if (sine(x) != both.sine || cosine(x) != both.cosine) FAIL("at " << x);
        }
    }
    for (const double x : {0.0, -0.0}) {
        CHECK(std::signbit(sine(x)) == std::signbit(sine_cosine(x).sine));
        CHECK(cosine(x) == 1.0);
    }
}

TEST_CASE("sine and cosine of huge angles stay on the unit circle", "[math][elementary]") {
    for (double x = 1e6; x < 1e300; x *= 37.0) {
        const SineCosine both = sine_cosine(x);
        CHECK(both.sine * both.sine + both.cosine * both.cosine == Approx(1.0).epsilon(1e-14));
        CHECK(sine(-x) == -both.sine);
        CHECK(cosine(-x) == both.cosine);
    }
}

TEST_CASE("the arc tangent is exact to 4e-16", "[math][elementary]") {
    for (const double reach : {0.3, 1.1, 10.0, 1e9})
        CHECK(errors_of(arc_tangent, exact_arc_tangent, -reach, reach).absolute < 4e-16L);
    CHECK(arc_tangent(kInfinity) == kPi / 2);
    CHECK(arc_tangent(-kInfinity) == -kPi / 2);
}

TEST_CASE("the arc tangent of two numbers agrees with atan2 all around", "[math][elementary]") {
    RandomStream stream(12);
    for (int i = 0; i < kPoints; ++i) {
        const double y = stream.uniform(-2.0, 2.0);
        const double x = stream.uniform(-2.0, 2.0);
        REQUIRE(arc_tangent2(y, x) == Approx(std::atan2(y, x)).margin(1e-15));
    }
    CHECK(arc_tangent2(0.0, 0.0) == 0.0);
    CHECK(arc_tangent2(0.0, -1.0) == kPi);
    CHECK(arc_tangent2(2.0, 0.0) == kPi / 2);
    CHECK(arc_tangent2(-2.0, 0.0) == -kPi / 2);
}

TEST_CASE("the exponential is exact to 4e-16 of its value", "[math][elementary]") {
    CHECK(errors_of(exponential, exact_exponential, -1.0, 1.0).relative < 4e-16L);
    CHECK(errors_of(exponential, exact_exponential, -708.0, 709.0).relative < 4e-16L);
    CHECK(exponential(0.0) == 1.0);
}

TEST_CASE("the exponential ends in 0 and infinity", "[math][elementary]") {
    CHECK(exponential(710.0) == kInfinity);
    CHECK(exponential(kInfinity) == kInfinity);
    CHECK(exponential(-746.0) == 0.0);
    CHECK(exponential(-kInfinity) == 0.0);
    CHECK(exponential(709.78) == Approx(std::exp(709.78)).epsilon(1e-15));
    // Below the normal range, the result may differ in its last bit.
    CHECK(std::fabs(exponential(-745.0) - std::exp(-745.0)) <=
          std::numeric_limits<double>::denorm_min());
}

TEST_CASE("the logarithm is exact to 4e-16 of its value", "[math][elementary]") {
    for (const double high : {1e-300, 1e-3, 1.0, 2.0, 10.0, 1e300})
        CHECK(errors_of(logarithm, exact_logarithm, 0.0, high).relative < 4e-16L);
    CHECK(errors_of(logarithm, exact_logarithm, 0.99, 1.01).relative < 4e-16L);
    CHECK(logarithm(1.0) == 0.0);
}

TEST_CASE("the logarithm knows the ends of its domain", "[math][elementary]") {
    CHECK(logarithm(0.0) == -kInfinity);
    CHECK(logarithm(kInfinity) == kInfinity);
    CHECK(std::isnan(logarithm(-1.0)));
    const double smallest = std::numeric_limits<double>::denorm_min();
    CHECK(logarithm(smallest) == Approx(std::log(smallest)).epsilon(1e-15));
}

TEST_CASE("powers agree with pow", "[math][elementary]") {
    RandomStream stream(13);
    for (int i = 0; i < kPoints; ++i) {
        const double base = stream.uniform(0.001, 10.0);
        const double exponent = stream.uniform(-4.0, 4.0);
        REQUIRE(power(base, exponent) == Approx(std::pow(base, exponent)).epsilon(1e-14));
    }
}

TEST_CASE("what is not a number stays not a number", "[math][elementary]") {
    for (const Function function : {sine, cosine, arc_tangent, exponential, logarithm})
        CHECK(std::isnan(function(kNaN)));
    CHECK(std::isnan(sine(kInfinity)));
    for (const double other : {-1.0, 0.0, 1.0}) {
        CHECK(std::isnan(arc_tangent2(kNaN, other)));
        CHECK(std::isnan(arc_tangent2(other, kNaN)));
    }
}

TEST_CASE("the elementary functions give the same bits on every machine", "[math][elementary]") {
    // All scores depend on these bits; they change only when a formula changes.
    CHECK(bits_of(sine, -100.0, 100.0) == 0xf1099b1808aeb28cULL);
    CHECK(bits_of(cosine, -100.0, 100.0) == 0xa949fa72ad794d19ULL);
    CHECK(bits_of(arc_tangent, -20.0, 20.0) == 0xc54287635597892bULL);
    CHECK(bits_of(exponential, -700.0, 700.0) == 0x6c3e4a8aced2c5b5ULL);
    CHECK(bits_of(logarithm, 1e-3, 100.0) == 0xbfdcc4d271b4b6cfULL);
}
