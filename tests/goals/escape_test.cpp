#include "goals/goal.h"
#include "support/catch.h"
#include "support/records.h"

using namespace cambrian;
using test::moving_box;

namespace {

double escape_score(double speed, int side) {
    TrialRecord record =
        moving_box(15.0, 0.8, 0.2, [&](double t) { return Vec3(speed * t, 0.1, 0.0); });
    record.wall_side = side;
    return builtin_goals().find("escape")->score(record).value;
}

}  // namespace

TEST_CASE("escape scores the speed away from the wall only", "[goals][escape]") {
    for (const double speed : {0.2, 1.5}) {
        CHECK(escape_score(speed, -1) == Approx(speed / 0.8));
        CHECK(escape_score(-speed, 1) == Approx(speed / 0.8));
        CHECK(escape_score(speed, 1) == 0.0);
        CHECK(escape_score(-speed, -1) == 0.0);
    }
    CHECK(escape_score(1.0, 0) == 0.0);
}
