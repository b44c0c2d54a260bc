#include "goals/goal.h"
#include "support/catch.h"
#include "support/records.h"

using namespace cambrian;
using test::moving_box;

namespace {

double walking_score(const TrialRecord& record) {
    return builtin_goals().find("walking")->score(record).value;
}

}  // namespace

TEST_CASE("steady walking scores its speed in body lengths a second", "[goals][walking]") {
    for (const double speed : {-1.5, -0.2, 0.3, 2.0}) {
        const auto record =
            moving_box(15.0, 0.8, 0.2, [&](double t) { return Vec3(speed * t, 0.1, 0.0); });
        CHECK(walking_score(record) == Approx(std::abs(speed) / 0.8));
    }
}

TEST_CASE("standing still scores nothing", "[goals][walking]") {
    CHECK(walking_score(moving_box(15.0, 1.0, 0.2, [](double) { return Vec3(3.0, 0.1, 0.0); })) ==
          0.0);
}

TEST_CASE("a lunge in the first fifth of the trial earns nothing", "[goals][walking]") {
    const auto record = moving_box(
        15.0, 1.0, 0.2, [](double t) { return Vec3(t < 2.9 ? 10.0 * t : 29.0, 0.1, 0.0); });
    CHECK(walking_score(record) == 0.0);
}

TEST_CASE("one leap of a body length earns less than 0.03", "[goals][walking]") {
    for (const double when : {4.0, 8.0, 12.0}) {
        const auto record = moving_box(
            15.0, 1.0, 0.2, [&](double t) { return Vec3(t < when ? 0.0 : 1.0, 0.1, 0.0); });
        CHECK(walking_score(record) <= 0.3 / 12.0 + 1e-12);
    }
}

TEST_CASE("two leaps across seams of the windows earn less than 0.06", "[goals][walking]") {
    for (const double seam : {6.0, 9.0, 12.0}) {
        const auto record = moving_box(15.0, 1.0, 0.2, [&](double t) {
            return Vec3((t < seam - 0.5 ? 0.0 : 1.0) + (t < seam + 0.5 ? 0.0 : 1.0), 0.1, 0.0);
        });
        CHECK(walking_score(record) <= 2.0 * 0.3 / 12.0 + 1e-12);
    }
}

TEST_CASE("going there and back earns nothing", "[goals][walking]") {
    const auto record =
        moving_box(15.0, 1.0, 0.2, [](double t) { return Vec3(t < 9.0 ? t : 18.0 - t, 0.1, 0.0); });
    CHECK(walking_score(record) == 0.0);
}

TEST_CASE("an empty trial scores nothing", "[goals][walking]") {
    CHECK(walking_score(moving_box(0.0, 1.0, 0.2, [](double) { return Vec3(0, 0, 0); })) == 0.0);
}
