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

TEST_CASE("a ballistic jump scores its height and its capped speed", "[goals][jumping]") {
    const auto jump_at = [](double speed) {
        return moving_box(15.0, 1.0, 0.2, [speed](double t) {
            const double flight = t - 5.0;
            const double height = speed * flight - 0.5 * 9.81 * flight * flight;
            return Vec3(0.0, 0.1 + (flight > 0.0 && height > 0.0 ? height : 0.0), 0.0);
        });
    };
    // The greatest mean speed over 0.1 s is that of the first 0.1 s.
    CHECK(jumping_score(jump_at(2.0)) ==
          Approx(4.0 / 19.62 + 0.02 * (2.0 - 0.05 * 9.81)).epsilon(0.01));
    CHECK(jumping_score(jump_at(5.0)) == Approx(25.0 / 19.62 + 0.05).epsilon(0.01));
}

TEST_CASE("falling fast scores nothing, rising fast without a jump at most 0.05",
          "[goals][jumping]") {
    CHECK(jumping_score(moving_box(15.0, 1.0, 0.2,
                                   [](double t) { return Vec3(0.0, 20.0 - t, 0.0); })) == 0.0);
    TrialRecord record;
    for (int tick = 0; tick < 900; ++tick)
        record.jumps.watch(0.0, 0.1 * tick);
    CHECK(jumping_score(record) == Approx(0.05));
}

TEST_CASE("resting scores nothing", "[goals][jumping]") {
    CHECK(jumping_score(moving_box(15.0, 1.0, 0.2, [](double) { return Vec3(0.0, 0.1, 0.0); })) ==
          Approx(0.0).margin(1e-15));
}
