#include "genome/gene_fields.h"

#include "support/catch.h"

#include <cmath>

using namespace cambrian;

TEST_CASE("perturbed genes stay in their range", "[genome][fields]") {
    RandomStream stream(stream_seed(2, 0, 0, Purpose::kTest));
    const auto check = [&](const FieldRule& rule) {
        double x = rule.fallback;
        for (int i = 0; i < 5000; ++i) {
            x = perturb(x, rule, rule.step, stream);
            REQUIRE(in_range(x, rule));
        }
    };
    for (const auto& field : node_fields(3))
        check(field.rule);
    for (const auto& field : edge_fields(3))
        check(field.rule);
    for (const auto& field : degree_fields())
        check(field.rule);
    for (const auto& field : input_fields())
        check(field.rule);
    for (const auto& field : genome_fields(3))
        check(field.rule);
}

TEST_CASE("a perturbation's spread is relative to the value, with a floor", "[genome][fields]") {
    RandomStream stream(stream_seed(3, 0, 0, Purpose::kTest));
    const FieldRule wide = {"", "", -1e6, 1e6, 0.0};
    const GeneStep step = {.relative = 0.2, .floor = 0.1, .long_factor = 4.0, .long_share = 0.15};
    // The mean square of m is 0.85 + 0.15 * 16 = 3.25.
    for (const double x : {0.0, 0.05, 10.0}) {
        double squares = 0.0;
        for (int i = 0; i < 40000; ++i) {
            const double change = perturb(x, wide, step, stream) - x;
            squares += change * change;
        }
        const double expected = std::sqrt(3.25) * 0.2 * std::fmax(std::fabs(x), 0.1);
        CHECK(std::sqrt(squares / 40000) == Approx(expected).epsilon(0.03));
    }
}

TEST_CASE("a value just below a circle's start wraps to inside it", "[genome][fields]") {
    const FieldRule& position = edge_fields(3)[0].rule;
    CHECK(in_range(fit(-1e-20, position), position));
    CHECK(in_range(fit(1.0, position), position));
    CHECK(fit(-0.25, position) == 0.75);
}
