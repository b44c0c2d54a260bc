#include "goals/goal.h"
#include "math/angle.h"
#include "support/catch.h"
#include "support/records.h"

#include <cmath>

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

namespace {

// Returns the score in space of a disc, or of one on a slope that rises towards +x.
double score_in_space(const std::function<Vec3(double)>& path, double rise = 0.0) {
    TrialRecord record = moving_box(15.0, 0.8, 0.2, path);
    record.dimensions = 3;
    record.up = Vec3(rise, 1.0, 0.0).normalized();
    return walking_score(record);
}

}  // namespace

TEST_CASE("in space every direction is worth nearly the same", "[goals][walking]") {
    for (int degrees = 0; degrees < 360; degrees += 5) {
        const double turn = degrees * kPi / 180.0;
        const auto walk = [&](double t) {
            return Vec3(0.4 * t * std::cos(turn), 0.1, 0.4 * t * std::sin(turn));
        };
        const double score = score_in_space(walk);
        CHECK(score <= 0.5 + 1e-12);
        CHECK(score >= 0.5 * std::cos(kPi / 16.0) - 1e-12);
        if (degrees % 90 == 0) CHECK(score == Approx(0.5));
    }
}

TEST_CASE("in space a circle earns little", "[goals][walking]") {
    // One body length across, once in 2.5 s.
    const double speed = kPi / 2.5;
    const auto circle = [](double t) {
        const double turn = 2.0 * kPi * t / 2.5;
        return Vec3(0.4 * std::cos(turn), 0.1, 0.4 * std::sin(turn));
    };
    CHECK(score_in_space(circle) < 0.1 * speed);
}

TEST_CASE("in space only the way uphill counts on a slope", "[goals][walking]") {
    const auto along = [](const Vec3& speed) {
        return [speed](double t) { return Vec3(t * speed + Vec3(0.0, 0.1, 0.0)); };
    };
    CHECK(score_in_space(along({0.4, 0.0, 0.0}), 0.1) == Approx(0.5));
    CHECK(score_in_space(along({-0.4, 0.0, 0.0}), 0.1) == 0.0);
    CHECK(score_in_space(along({0.0, 0.0, 0.4}), 0.1) == Approx(0.0).margin(1e-12));
    CHECK(score_in_space(along({-0.4, 0.0, 0.0}), -0.1) == Approx(0.5));
}

TEST_CASE("an empty trial scores nothing", "[goals][walking]") {
    CHECK(walking_score(moving_box(0.0, 1.0, 0.2, [](double) { return Vec3(0, 0, 0); })) == 0.0);
}
