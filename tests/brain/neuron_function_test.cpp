#include "brain/single_neuron.h"
#include "math/elementary.h"
#include "support/catch.h"

#include <cmath>
#include <limits>

using namespace cambrian;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::array<double, 10> kCorners = {
    0.0,  0.001, -0.001,    1.0,        -1.0,
    10.0, -10.0, kInfinity, -kInfinity, std::numeric_limits<double>::quiet_NaN()};

bool close(double a, double reference) {
    return std::fabs(a - reference) <= 1e-6 * std::fmax(1.0, std::fabs(reference));
}

}  // namespace

TEST_CASE("there are twenty-three functions of one to three inputs", "[brain][functions]") {
    const NeuronFunctionRegistry functions = builtin_neuron_functions();
    CHECK(functions.size() == 23);
    for (const NeuronFunctionKind& function : functions.all()) {
        CHECK(function.arity >= 1);
        CHECK(function.arity <= 3);
        CHECK((function.input_hints.empty() ||
               function.input_hints.size() == static_cast<std::size_t>(function.arity)));
    }
}

TEST_CASE("every function answers any input, tick after tick, within the limits",
          "[brain][functions]") {
    const NeuronFunctionRegistry functions = builtin_neuron_functions();
    for (const NeuronFunctionKind& function : functions.all()) {
        INFO(function.id);
        SingleNeuron neuron(function.id);
        for (const double a : kCorners) {
            for (const double b : kCorners) {
                for (const double c : kCorners) {
                    const double result = neuron({a, b, c});
                    REQUIRE(std::fabs(result) <= kSignalLimit);
                }
            }
        }
    }
}

TEST_CASE("arithmetic functions calculate", "[brain][functions]") {
    CHECK(SingleNeuron("sum")({1.0, 2.5, -0.5}) == 3.0);
    CHECK(SingleNeuron("product")({3.0, -2.0}) == -6.0);
    CHECK(SingleNeuron("divide")({3.0, -2.0}) == -1.5);
    CHECK(SingleNeuron("divide")({0.05, 0.0}) == Approx(5.0));
    CHECK(SingleNeuron("divide")({0.05, -0.001}) == Approx(-5.0));
    CHECK(SingleNeuron("sign-of")({-0.2}) == -1.0);
    CHECK(SingleNeuron("sign-of")({0.0}) == 0.0);
    CHECK(SingleNeuron("min")({2.0, -1.0}) == -1.0);
    CHECK(SingleNeuron("max")({2.0, -1.0}) == 2.0);
    CHECK(SingleNeuron("abs")({-4.0}) == 4.0);
    CHECK(SingleNeuron("interpolate")({0.25, 1.0, 5.0}) == 2.0);
    CHECK(SingleNeuron("interpolate")({7.0, 1.0, 5.0}) == 5.0);
}

TEST_CASE("logic functions answer plus or minus one, or choose", "[brain][functions]") {
    CHECK(SingleNeuron("sum-threshold")({1.0, 2.0, 2.9}) == 1.0);
    CHECK(SingleNeuron("sum-threshold")({1.0, 2.0, 3.0}) == -1.0);
    CHECK(SingleNeuron("greater-than")({1.0, 0.5}) == 1.0);
    CHECK(SingleNeuron("greater-than")({0.5, 0.5}) == -1.0);
    CHECK(SingleNeuron("if")({0.1, 5.0, -5.0}) == 5.0);
    CHECK(SingleNeuron("if")({0.0, 5.0, -5.0}) == -5.0);
}

TEST_CASE("analytic functions agree with the reference formulas", "[brain][functions]") {
    SingleNeuron sin("sin"), cos("cos"), atan("atan"), log("log"), expt("expt"), sigmoid("sigmoid");
    for (double a = -10.0; a <= 10.0; a += 0.037) {
        const double positive = std::fmax(std::fabs(a), 0.001);
        REQUIRE(close(sin({a}), std::sin(a)));
        REQUIRE(close(cos({a}), std::cos(a)));
        REQUIRE(close(atan({a}), std::atan(a)));
        REQUIRE(close(log({a}), std::log(positive)));
        REQUIRE(close(sigmoid({a}), 2.0 / (1.0 + std::exp(-a)) - 1.0));
        for (const double b : {-5.0, -1.5, 0.0, 0.3, 4.0}) {
            const double power = std::pow(positive, std::fmin(std::fmax(b, -4.0), 4.0));
            REQUIRE(close(expt({a, b}), std::fmin(power, 10.0)));
        }
    }
}

TEST_CASE("an integrator integrates and slowly forgets", "[brain][functions]") {
    SingleNeuron integrate("integrate");
    for (int i = 0; i < 60; ++i)
        integrate({1.0});
    const double after_a_second = integrate({0.0});
    CHECK(after_a_second == Approx(0.95).margin(0.01));
    for (int i = 0; i < 599; ++i)
        integrate({0.0});
    CHECK(integrate({0.0}) == Approx(after_a_second * std::exp(-1.0)).epsilon(0.01));
}

TEST_CASE("a differentiator answers the rate, and 0 at first", "[brain][functions]") {
    SingleNeuron differentiate("differentiate");
    CHECK(differentiate({3.0}) == 0.0);
    CHECK(differentiate({3.1}) == Approx(6.0));
    CHECK(differentiate({3.1}) == 0.0);
}

TEST_CASE("smoothing approaches with its second input as time constant", "[brain][functions]") {
    SingleNeuron smooth("smooth");
    double value = 0.0;
    for (int i = 0; i < 30; ++i)
        value = smooth({2.0, -0.5});
    CHECK(value == Approx(2.0 * (1.0 - std::exp(-1.0))));
}

TEST_CASE("memory holds what it last sampled", "[brain][functions]") {
    SingleNeuron memory("memory");
    CHECK(memory({4.0, 0.0}) == 0.0);
    CHECK(memory({4.0, 1.0}) == 4.0);
    CHECK(memory({7.0, -1.0}) == 4.0);
}

TEST_CASE("oscillators keep their frequency, at most 4 Hz, and phase", "[brain][functions]") {
    SingleNeuron wave("oscillate-wave"), saw("oscillate-saw");
    for (int tick = 1; tick <= 120; ++tick) {
        const double time = tick / 60.0;
        REQUIRE(wave({-1.5, 0.25}) == Approx(std::sin(2 * kPi * (1.5 * time + 0.25))).margin(1e-9));
        REQUIRE(saw({9.0, 0.1}) == Approx(2 * std::fmod(4.0 * time + 0.1, 1.0) - 1).margin(1e-9));
    }
}

TEST_CASE("an oscillator stays continuous when its frequency changes", "[brain][functions]") {
    SingleNeuron wave("oscillate-wave");
    double previous = wave({1.0, 0.0});
    for (int tick = 0; tick < 300; ++tick) {
        const double next = wave({1.0 + 0.5 * std::sin(0.1 * tick), 0.0});
        REQUIRE(std::fabs(next - previous) < 2 * kPi * 1.5 / 60.0 + 1e-9);
        previous = next;
    }
}
