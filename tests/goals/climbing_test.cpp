#include "goals/goal.h"
#include "support/catch.h"
#include "support/records.h"

using namespace cambrian;
using test::moving_box;

namespace {

constexpr double kClimberLength = 0.8;  // m

// Returns the score of a box that moves over stairs or a slope that rise to both sides by this much
// each metre.
double climbing_score(double speed, double rise) {
    TrialRecord record =
        moving_box(15.0, kClimberLength, 0.2, [&](double t) { return Vec3(speed * t, 0.1, 0.0); });
    for (MotionSample& sample : record.samples) {
        sample.ground_low = rise * std::fabs(sample.bounds.low.x());
        sample.ground_high = rise * std::fabs(sample.bounds.high.x());
    }
    return builtin_goals().find("climbing")->score(record).value;
}

}  // namespace

TEST_CASE("climbing scores the gain of height of the ground that was walked", "[goals][climbing]") {
    for (const double speed : {0.5, -0.5}) {
        CHECK(climbing_score(speed, 0.2) == Approx(0.2 * 0.5 / kClimberLength));
        CHECK(climbing_score(speed, 0.0) == 0.0);
    }
    CHECK(climbing_score(0.0, 0.2) == 0.0);
    CHECK(climbing_score(0.5, -0.2) == 0.0);
}

TEST_CASE("a leap on level ground does not climb", "[goals][climbing]") {
    const TrialRecord record = moving_box(
        15.0, kClimberLength, 0.2, [](double t) { return Vec3(0.2 * t, 0.1 + 0.5 * t, 0.0); });
    CHECK(builtin_goals().find("climbing")->score(record).value == 0.0);
}
