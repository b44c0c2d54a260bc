#include "goals/goal.h"
#include "support/catch.h"
#include "support/records.h"

using namespace cambrian;
using test::moving_box;

namespace {

constexpr double kPad = 1.5;           // m
constexpr double kRunnerLength = 1.0;  // m

// Returns the score of a box whose trailing edge begins at -0.5 m and goes so far and back by half
// a metre.
double course_score(double way, int direction = 1) {
    TrialRecord record = moving_box(30.0, kRunnerLength, 0.2, [&](double t) {
        const double share = t < 20.0 ? t / 20.0 : 1.0 - 0.05 * (t - 20.0) / way;
        return Vec3(direction * way * share, 0.1, 0.0);
    });
    record.level_ground = kPad;
    return builtin_goals().find("course")->score(record).value;
}

}  // namespace

TEST_CASE("a course scores the obstacles that the trailing edge left behind", "[goals][course]") {
    CHECK(course_score(5.0) == Approx(1.0));
    CHECK(course_score(2.5) == Approx(0.5));
    CHECK(course_score(14.0) == Approx(4.0));
    CHECK(course_score(15.5) == Approx(4.5));
    CHECK(course_score(14.0, -1) == Approx(4.0));
}

TEST_CASE("time counts once all obstacles of a course are passed", "[goals][course]") {
    CHECK(course_score(32.0) == Approx(10.0 + 0.5 / 3.0).margin(0.01));
    CHECK(course_score(64.0) == Approx(10.0 + 0.5 * 2.0 / 3.0).margin(0.01));
}
