#include "goals/goal.h"
#include "support/catch.h"
#include "support/records.h"

#include <cmath>

using namespace cambrian;
using test::moving_box;

namespace {

double swimming_score(const TrialRecord& record) {
    return builtin_goals().find("swimming")->score(record).value;
}

}  // namespace

TEST_CASE("steady swimming in any direction scores its speed in body lengths a second",
          "[goals][swimming]") {
    for (const double angle : {0.0, 1.0, 2.5, -2.0}) {
        const auto record = moving_box(15.0, 0.5, 0.1, [&](double t) {
            return Vec3(0.4 * t * std::cos(angle), 0.4 * t * std::sin(angle), 0.0);
        });
        CHECK(swimming_score(record) == Approx(0.8));
    }
}

TEST_CASE("drifting on after one push scores far less than its mean speed", "[goals][swimming]") {
    const auto record = moving_box(
        15.0, 1.0, 0.1, [](double t) { return Vec3(15.0 * (1.0 - std::exp(-t)), 0.0, 0.0); });
    CHECK(swimming_score(record) < 0.05);
}

TEST_CASE("full circles score less than a tenth of the speed swum", "[goals][swimming]") {
    const auto record = moving_box(
        15.0, 1.0, 0.1, [](double t) { return Vec3(std::cos(2.0 * t), std::sin(2.0 * t), 0.0); });
    CHECK(swimming_score(record) < 0.2);
}
