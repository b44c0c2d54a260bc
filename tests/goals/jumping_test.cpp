#include "goals/goal.h"
#include "support/catch.h"
#include "support/records.h"

using namespace cambrian;
using test::moving_box;

namespace {

double jumping_score(const TrialRecord& record) {
    return builtin_goals().find("jumping")->score(record).value;
}

}  // namespace

TEST_CASE("a ballistic jump scores its height and a capped share of its rise", "[goals][jumping]") {
    // Lowest point leaves the ground at t = 5 s with 3 m/s: 0.4587 m high, up to sampling.
    const auto record = moving_box(15.0, 1.0, 0.2, [](double t) {
        const double flight = t - 5.0;
        const double height = 3.0 * flight - 0.5 * 9.81 * flight * flight;
        return Vec3(0.0, 0.1 + (flight > 0.0 && height > 0.0 ? height : 0.0), 0.0);
    });
    CHECK(jumping_score(record) == Approx(1.2 * 0.4587).margin(0.01));
}

TEST_CASE("raising only the centre of mass pays at most a tenth of a body length",
          "[goals][jumping]") {
    TrialRecord record = moving_box(15.0, 1.0, 0.2, [](double) { return Vec3(0.0, 0.1, 0.0); });
    record.samples[70].center_of_mass.y() += 5.0;
    CHECK(jumping_score(record) == Approx(0.1));
}

TEST_CASE("resting scores nothing", "[goals][jumping]") {
    CHECK(jumping_score(moving_box(15.0, 1.0, 0.2, [](double) { return Vec3(0.0, 0.1, 0.0); })) ==
          Approx(0.0).margin(1e-15));
}
