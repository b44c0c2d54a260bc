#include "studio/playback/playback.h"

#include "evolution/evaluation/trials.h"
#include "pictures/motion/recorded_motion.h"
#include "studio_fixture.h"
#include "support/catch.h"

namespace cambrian {
namespace {

ExperimentSettings short_trial() {
    ExperimentSettings settings;
    settings.world.trial.duration = 1.0;
    settings.world.trial.settle_limit = 0.2;
    return settings;
}

Exhibit crawler_exhibit() {
    return test::crawler_exhibit(short_trial());
}

constexpr double kPlenty = 1e3;  // s; a budget that is never used up

TEST_CASE("the displayed motion equals the scored one to the last bit", "[studio][playback]") {
    Playback playback(test::kinds().creature);
    const Exhibit exhibit = crawler_exhibit();
    REQUIRE(playback.show(exhibit));
    while (!playback.trial().finished())
        playback.advance(1.0 / 60.0, kPlenty);
    const auto phenotype = std::make_shared<const Phenotype>(
        express(*exhibit.genome(), test::kinds().creature, {}, {}));
    const auto record = run_trial(phenotype, test::kinds().creature, exhibit.settings().world);
    REQUIRE(record);
    CHECK(playback.trial().record().digest == record->digest);
}

TEST_CASE("further trials are the scored ones, and restart as themselves", "[studio][playback]") {
    ExperimentSettings settings = short_trial();
    settings.world.trial.trials = 4;
    settings.world.trial.tilt_jitter = 5.0;
    settings.world.environment.has_wall = true;
    Playback playback(test::kinds().creature);
    const Exhibit exhibit = test::crawler_exhibit(settings);
    REQUIRE(playback.show(exhibit));
    for (const int trial : {3, 1, 0}) {
        playback.show_trial(trial);
        for (int repetition = 0; repetition < 2; ++repetition) {
            CHECK(playback.creature().trial_number() == trial);
            while (!playback.trial().finished())
                playback.advance(1.0 / 60.0, kPlenty);
            const TrialSetup setup = trial_setup(exhibit.genome(), settings, trial);
            const auto phenotype = std::make_shared<const Phenotype>(
                express(*setup.genome, test::kinds().creature, {}, {}));
            const auto record = run_trial(phenotype, test::kinds().creature, setup.world);
            REQUIRE(record);
            CHECK(playback.trial().record().digest == record->digest);
            playback.restart();
        }
    }
    REQUIRE(playback.show(exhibit));
    CHECK(playback.creature().trial_number() == 0);
}

TEST_CASE("playing twice as fast plays twice as far", "[studio][playback]") {
    Playback playback(test::kinds().creature);
    REQUIRE(playback.show(crawler_exhibit()));
    playback.pace().speed = 2.0;
    for (int i = 0; i < 20; ++i)
        playback.advance(kBrainTick, kPlenty);
    CHECK(playback.trial().ticks() >= 39);
    CHECK(playback.trial().ticks() <= 40);
}

TEST_CASE("motion beyond the time budget is played later", "[studio][playback]") {
    Playback playback(test::kinds().creature);
    REQUIRE(playback.show(crawler_exhibit()));
    playback.advance(0.1, 0.0);
    CHECK(playback.trial().ticks() == 0);
}

TEST_CASE("paused, only single ticks move the creature", "[studio][playback]") {
    Playback playback(test::kinds().creature);
    REQUIRE(playback.show(crawler_exhibit()));
    playback.pace().playing = false;
    playback.advance(1.0, kPlenty);
    CHECK(playback.trial().ticks() == 0);
    playback.step();
    CHECK(playback.trial().ticks() == 1);
}

TEST_CASE("a step back ends where the step before had ended", "[studio][playback]") {
    Playback playback(test::kinds().creature);
    REQUIRE(playback.show(crawler_exhibit()));
    std::vector<Vec3> centers = {playback.creature().motion().center()};
    for (int i = 0; i < 70; ++i) {
        playback.step();
        centers.push_back(playback.creature().motion().center());
    }
    for (std::size_t tick = 70; tick-- > 0;) {
        playback.step_back();
        playback.advance(0.0, kPlenty);
        REQUIRE(playback.trial().ticks() == tick);
        CHECK(playback.creature().motion().center() == centers[tick]);
    }
    playback.step_back();
    CHECK(playback.tick_shown() == 0);
}

TEST_CASE("going back in a trial does not change its score", "[studio][playback]") {
    Playback playback(test::kinds().creature);
    REQUIRE(playback.show(crawler_exhibit()));
    const auto digest = [&playback] {
        playback.pace().playing = true;
        while (!playback.trial().finished())
            playback.advance(1.0 / 60.0, kPlenty);
        return playback.trial().record().digest;
    };
    const std::uint64_t straight = digest();
    playback.seek(37);
    playback.advance(0.0, kPlenty);
    CHECK_FALSE(playback.trial().finished());
    CHECK(digest() == straight);
}

TEST_CASE("going back to before a poke undoes it, going back to after it does not",
          "[studio][playback]") {
    Playback playback(test::kinds().creature);
    REQUIRE(playback.show(crawler_exhibit()));
    for (int i = 0; i < 40; ++i)
        playback.step();
    playback.creature().pull(Hold{0, Vec3::Zero(), Vec3(0.0, 5.0, 0.0)});
    for (int i = 0; i < 10; ++i)
        playback.step();
    playback.creature().pull(std::nullopt);
    for (int i = 0; i < 20; ++i)
        playback.step();
    playback.seek(60);
    playback.advance(0.0, kPlenty);
    CHECK(is_disturbed(playback.creature()));
    playback.seek(40);
    playback.advance(0.0, kPlenty);
    CHECK_FALSE(is_disturbed(playback.creature()));
}

TEST_CASE("seeking a later moment is spread over the budgets of several frames",
          "[studio][playback]") {
    Playback playback(test::kinds().creature);
    REQUIRE(playback.show(crawler_exhibit()));
    playback.pace().playing = false;
    playback.seek(50);
    playback.advance(0.01, 0.0);
    CHECK(playback.seeking());
    CHECK(playback.tick_shown() == 50);
    playback.advance(0.01, kPlenty);
    CHECK_FALSE(playback.seeking());
    CHECK(playback.trial().ticks() == 50);
}

TEST_CASE("less gravity makes a creature in the air fall slower at once", "[studio][playback]") {
    ExperimentSettings in_the_air = short_trial();
    in_the_air.world.environment.has_ground = false;
    const Exhibit exhibit = test::crawler_exhibit(in_the_air);
    double fallen[2] = {0.0, 0.0};
    for (const int moon : {0, 1}) {
        Playback playback(test::kinds().creature);
        REQUIRE(playback.show(exhibit));
        Environment world = exhibit.settings().world.environment;
        if (moon == 1) world.gravity = 1.62;
        playback.creature().set_environment(world);
        for (int i = 0; i < 30; ++i)
            playback.step();
        fallen[moon] = -playback.trial().scene().center_of_mass().y();
    }
    CHECK(fallen[0] == Approx(0.5 * 9.81 * 0.25).epsilon(0.02));
    CHECK(fallen[1] == Approx(0.5 * 1.62 * 0.25).epsilon(0.02));
}

TEST_CASE("restarting forgets a poke and keeps a changed world", "[studio][playback]") {
    Playback playback(test::kinds().creature);
    REQUIRE(playback.show(crawler_exhibit()));
    Environment moon;
    moon.gravity = 1.62;
    playback.creature().set_environment(moon);
    playback.creature().pull(Hold{0, Vec3::Zero(), Vec3(0.0, 5.0, 0.0)});
    playback.step();
    CHECK(is_disturbed(playback.creature()));
    playback.restart();
    CHECK_FALSE(is_disturbed(playback.creature()));
    CHECK(playback.trial().ticks() == 0);
    CHECK(playback.creature().replay().environment() == moon);
}

TEST_CASE("a poke pulls the creature towards the mouse", "[studio][playback]") {
    ExperimentSettings afloat = short_trial();
    afloat.world.environment.has_ground = false;
    afloat.world.environment.gravity = 0.0;
    const Exhibit exhibit = test::crawler_exhibit(afloat);
    Playback playback(test::kinds().creature);
    REQUIRE(playback.show(exhibit));
    const double before = playback.trial().scene().center_of_mass().x();
    for (int i = 0; i < 20; ++i) {
        playback.creature().pull(Hold{0, Vec3::Zero(), Vec3(2.0, 0.0, 0.0)});
        playback.step();
    }
    CHECK(playback.trial().scene().center_of_mass().x() > before + 0.1);
}

TEST_CASE("a forced neuron disturbs the motion until restarted", "[studio][playback]") {
    Playback free(test::kinds().creature);
    Playback forced(test::kinds().creature);
    REQUIRE(free.show(crawler_exhibit()));
    REQUIRE(forced.show(crawler_exhibit()));
    forced.creature().force(0, 2.0);
    CHECK(is_disturbed(forced.creature()));
    for (int i = 0; i < 60; ++i) {
        free.step();
        forced.step();
    }
    CHECK(forced.trial().creature().brain().value(
              forced.creature().phenotype().network.neuron_slot(0)) == 2.0);
    CHECK(forced.creature().motion().poses()[1].position !=
          free.creature().motion().poses()[1].position);
    forced.restart();
    CHECK(forced.creature().replay().forced().empty());
    CHECK_FALSE(is_disturbed(forced.creature()));
    free.restart();
    for (int i = 0; i < 60; ++i) {
        free.step();
        forced.step();
    }
    CHECK(forced.creature().motion().poses()[1].position ==
          free.creature().motion().poses()[1].position);
}

TEST_CASE("the last 3 s of every signal are kept", "[studio][playback]") {
    Playback playback(test::kinds().creature);
    REQUIRE(playback.show(crawler_exhibit()));
    for (std::size_t i = 0; i < SignalTrace::kLength + 20; ++i)
        playback.step();
    const Brain& brain = playback.trial().creature().brain();
    const Slot slot = playback.creature().phenotype().network.neuron_slot(0);
    CHECK(playback.creature().readings().signals().of_slot(slot).size() == SignalTrace::kLength);
    CHECK(playback.creature().readings().signals().of_slot(slot).back() == brain.value(slot));
    CHECK(playback.creature().readings().signals().of_output(1).back() == brain.output(1));
}

TEST_CASE("a played and a recorded trial tell the same path and scuffs, after going back too",
          "[studio][playback]") {
    const Exhibit exhibit = crawler_exhibit();
    const auto phenotype = std::make_shared<const Phenotype>(
        express(*exhibit.genome(), test::kinds().creature, {}, {}));
    const auto recorded =
        record_trial(phenotype, test::kinds().creature, first_trial_world(exhibit.settings()));
    REQUIRE(recorded);
    Playback playback(test::kinds().creature);
    REQUIRE(playback.show(exhibit));
    const auto play_to = [&](double time) {
        while (playback.trial().settling() || playback.trial().time() < time - 1e-9)
            playback.step();
    };
    const auto check = [&] {
        const double time = playback.trial().time();
        const TrialReadings& readings = playback.creature().readings();
        const std::vector<Vec2> path = recorded->motion.trail(time, 48);
        REQUIRE(readings.trail().size() == path.size());
        CHECK(std::equal(path.begin(), path.end(), readings.trail().begin()));
        const auto seen = scuffs_seen(readings.scuffs(), time);
        const auto wanted = scuffs_seen(recorded->motion.scuffs, time);
        REQUIRE(seen.size() == wanted.size());
        for (std::size_t i = 0; i < seen.size(); ++i) {
            CHECK(seen[i].place == wanted[i].place);
            CHECK(seen[i].seed == wanted[i].seed);
        }
    };
    play_to(0.9);
    check();
    CHECK_FALSE(playback.creature().readings().scuffs().empty());
    const std::uint64_t there = playback.trial().ticks();
    playback.seek(there - 23);
    while (playback.seeking())
        playback.advance(kBrainTick, kPlenty);
    check();
    play_to(0.9);
    check();
}

}  // namespace
}  // namespace cambrian
