#include "simulator/tick_checks.h"

#include "support/catch.h"
#include "support/creatures.h"
#include "support/kinds.h"

using namespace cambrian;
using namespace cambrian::test;

namespace {

// Returns the check bytes of a trial of 1 s, with a push at a tick unless that is 0.
TickChecks checks_of(std::uint64_t pushed_at) {
    TrialWorld world;
    world.trial.duration = 1.0;
    const auto phenotype = std::make_shared<const Phenotype>(
        express(*crawler(kinds().creature.catalog), kinds().creature, {}, world.scene));
    auto trial = Trial::start(phenotype, kinds().creature, world);
    REQUIRE(trial);
    TickChecks checks;
    for (bool more = true; more; note_tick(checks, **trial)) {
        if ((*trial)->ticks() + 1 == pushed_at)
            (*trial)->scene().pull(0, Vec3::Zero(), Vec3(1e-9, 0.0, 0.0));
        more = (*trial)->tick();
    }
    CHECK(checks.size() == (*trial)->ticks());
    return checks;
}

}  // namespace

TEST_CASE("the tick that differs is found", "[simulator][tick_checks]") {
    const TickChecks checks = checks_of(0);
    CHECK(checks.size() >= 60);
    CHECK_FALSE(first_different_tick(checks, checks_of(0)));
    const std::uint64_t pushed_at = GENERATE(1U, 2U, 17U, 50U);
    const auto tick = first_different_tick(checks, checks_of(pushed_at));
    REQUIRE(tick);
    CHECK(*tick >= pushed_at);
    CHECK(*tick <= pushed_at + 1);  // one byte in 256 is equal by chance
}

TEST_CASE("motions of different lengths differ after the shorter one", "[simulator][tick_checks]") {
    CHECK(first_different_tick({1, 2, 3}, {1, 2}) == 3U);
    CHECK(first_different_tick({}, {1}) == 1U);
    CHECK_FALSE(first_different_tick({}, {}));
}
