// Fleeing scored of a box that moves by a formula, with a light that appears twice.
#include "goals/goal.h"
#include "support/catch.h"
#include "support/records.h"

#include <cmath>

using namespace cambrian;

namespace {

const GoalKind& fleeing() {
    static const GoalRegistry goals = builtin_goals();
    return *goals.find("fleeing");
}

// The record of a box 0.8 m long in two legs of 5 s. The light appears at `first`, then at
// `second`.
TrialRecord record_of(const std::function<Vec3(double time)>& path, const Vec3& first,
                      const Vec3& second) {
    TrialRecord record = test::moving_box(10.0, 0.8, 0.2, path);
    record.legs.begin(0.0, first, 0.8);
    record.legs.begin(5.0, second, 0.8);
    return record;
}

// Goes to the right at a speed and, from half of the time on, at another one.
std::function<Vec3(double)> turning(double speed, double later) {
    return [=](double time) {
        return Vec3(speed * std::min(time, 5.0) + later * std::max(0.0, time - 5.0), 0.1, 0.0);
    };
}

}  // namespace

TEST_CASE("fleeing scores the speed away from where the light appeared", "[goals][fleeing]") {
    const Vec3 left(-3.0, 0.0, 0.0);
    const Vec3 right(3.0, 0.0, 0.0);
    struct Row {
        double speed, later;
        Vec3 first, second;
        double one, other;  // m/s
    };
    for (const Row& row : {Row{0.4, 0.4, left, left, 0.4, 0.4}, Row{0.4, 0.4, left, right, 0.4, 0},
                           Row{0.4, -0.2, left, right, 0.4, 0.2}, Row{0.4, 0.4, right, right, 0, 0},
                           Row{-0.4, 0.2, right, left, 0.4, 0.2}}) {
        const auto shares =
            fleeing().shares(record_of(turning(row.speed, row.later), row.first, row.second));
        REQUIRE(shares.size() == 2);
        CHECK(shares[0] == Approx(row.one / 0.8).margin(1e-12));
        CHECK(shares[1] == Approx(row.other / 0.8).margin(1e-12));
    }
    const Vec3 below(0.0, -2.0, 0.0);
    const auto rising = [](double time) { return Vec3(0.0, 0.4 * time, 0.0); };
    CHECK(fleeing().shares(record_of(rising, below, left))[0] == Approx(0.5));
    CHECK(fleeing().shares(record_of(rising, below, left))[1] == Approx(0.0).margin(1e-12));
}

TEST_CASE("who always flees one way has a tenth of the mean", "[goals][fleeing]") {
    CHECK(fleeing().score_of_shares(std::vector{1.0, 0.0, 0.0, 1.0}) == Approx(0.05));
    CHECK(fleeing().score_of_shares(std::vector{1.0, 1.0, 1.0, 1.0}) == Approx(1.0));
    CHECK(fleeing().score_of_shares(std::vector<double>{}) == 0.0);
}

TEST_CASE("a launch or a fall at the begin of a flight earns little", "[goals][fleeing]") {
    const Vec3 left(-3.0, 0.0, 0.0);
    const auto launched = [](double time) { return Vec3(std::min(2.0, 4.0 * time), 0.1, 0.0); };
    CHECK(fleeing().shares(record_of(launched, left, left))[0] == Approx(0.0).margin(1e-12));
    const auto falls_late = [](double time) { return Vec3(time < 3.0 ? 0.0 : 0.4, 0.1, 0.0); };
    const double share = fleeing().shares(record_of(falls_late, left, left))[0];
    CHECK(share == Approx(0.3 * 0.4 / (0.8 * 4.0)));
}
