#include "studio/playback/replay.h"

#include "support/catch.h"
#include "support/creatures.h"
#include "support/kinds.h"

namespace cambrian {
namespace {

std::unique_ptr<Replay> crawling() {
    const auto genome = test::crawler(test::kinds().creature.catalog);
    const auto phenotype =
        std::make_shared<const Phenotype>(express(*genome, test::kinds().creature, {}, {}));
    TrialWorld world;
    world.trial.duration = 2.0;
    auto replay = Replay::start(phenotype, test::kinds().creature, world);
    REQUIRE(replay);
    return std::move(*replay);
}

std::uint64_t bits_of(const Replay& replay) {
    Hash64 digest;
    replay.trial().scene().add_to_digest(digest);
    return digest.value();
}

void play_to(Replay& replay, std::uint64_t tick) {
    while (replay.ticks() < tick)
        replay.tick();
}

Environment moon() {
    Environment world;
    world.gravity = 1.62;
    return world;
}

TEST_CASE("going back and on again gives the same bits at every moment", "[studio][replay]") {
    const auto replay = crawling();
    std::vector<std::uint64_t> bits = {bits_of(*replay)};
    while (replay->ticks() < 200) {
        replay->tick();
        bits.push_back(bits_of(*replay));
    }
    for (const std::uint64_t tick : {199U, 120U, 119U, 31U, 30U, 29U, 0U, 77U}) {
        if (tick < replay->ticks()) replay->go_back(tick);
        play_to(*replay, tick);
        CHECK(bits_of(*replay) == bits[tick]);
    }
    play_to(*replay, 200);
    CHECK(bits_of(*replay) == bits[200]);
}

TEST_CASE("pulls and a changed world are repeated up to the moment sought", "[studio][replay]") {
    const auto replay = crawling();
    play_to(*replay, 45);
    replay->set_environment(moon());
    const Hold hold{0, Vec3::Zero(), Vec3(0.3, 1.0, 0.0)};
    while (replay->ticks() < 55)
        replay->tick(&hold);
    play_to(*replay, 70);
    const std::uint64_t there = bits_of(*replay);
    play_to(*replay, 100);
    replay->go_back(70);
    play_to(*replay, 70);
    CHECK(bits_of(*replay) == there);
    CHECK(replay->disturbed());
}

TEST_CASE("a forced neuron is repeated, and stays forced from the moment sought",
          "[studio][replay]") {
    const auto replay = crawling();
    play_to(*replay, 45);
    const std::uint64_t free = bits_of(*replay);
    replay->set_forced({{0, 0.8}});
    play_to(*replay, 70);
    const std::uint64_t forced = bits_of(*replay);
    CHECK(replay->disturbed());
    play_to(*replay, 100);
    replay->go_back(70);
    play_to(*replay, 70);
    CHECK(bits_of(*replay) == forced);
    replay->go_back(45);
    play_to(*replay, 45);
    CHECK(bits_of(*replay) == free);
    CHECK(replay->forced().count(0) == 1);
    play_to(*replay, 70);
    CHECK(bits_of(*replay) == forced);
    replay->go_back(45);
    replay->set_forced({});
    play_to(*replay, 70);
    CHECK(bits_of(*replay) != forced);
    CHECK_FALSE(replay->disturbed());
}

TEST_CASE("after going back, the present world acts from that moment on", "[studio][replay]") {
    const auto replay = crawling();
    const auto other = crawling();
    play_to(*replay, 80);
    replay->set_environment(moon());
    play_to(*replay, 90);
    replay->go_back(40);
    CHECK(replay->environment() == moon());
    play_to(*other, 40);
    play_to(*replay, 40);
    CHECK(bits_of(*replay) == bits_of(*other));
    other->set_environment(moon());
    play_to(*other, 80);
    play_to(*replay, 80);
    CHECK(bits_of(*replay) == bits_of(*other));
}

TEST_CASE("any moment of a long trial can be gone back to", "[studio][replay]") {
    const auto replay = crawling();
    play_to(*replay, 55);
    const std::uint64_t early = bits_of(*replay);
    play_to(*replay, 9'000);
    replay->go_back(55);
    play_to(*replay, 55);
    CHECK(bits_of(*replay) == early);
}

}  // namespace
}  // namespace cambrian
