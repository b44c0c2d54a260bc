#include "simulator/trial.h"

#include "support/catch.h"
#include "support/creatures.h"
#include "support/kinds.h"

using namespace cambrian;

namespace {

std::shared_ptr<const Phenotype> grown(const GenomePtr& genome, const TrialWorld& world = {}) {
    return std::make_shared<const Phenotype>(
        express(*genome, test::creature_kinds(), ExpressionSettings{}, world.scene));
}

TrialRecord run(const GenomePtr& genome, const TrialWorld& world = {}) {
    auto record = run_trial(grown(genome), test::creature_kinds(), world);
    REQUIRE(record);
    return *record;
}

}  // namespace

TEST_CASE("a trial samples every tenth of a second from the start to the end", "[simulator]") {
    const TrialRecord record = run(test::crawler(test::creature_kinds().catalog));
    REQUIRE(record.outcome == Outcome::kCompleted);
    REQUIRE(record.samples.size() == 151);
    CHECK(record.samples.front().time == 0.0);
    CHECK(record.samples.back().time == Approx(15.0));
    CHECK(record.samples[70].time == Approx(7.0));
}

TEST_CASE("a creature starts 2 cm above the ground over x = 0", "[simulator]") {
    auto trial = Trial::start(grown(test::crawler(test::creature_kinds().catalog)),
                              test::creature_kinds(), {});
    REQUIRE(trial);
    const PhysicsScene& scene = (*trial)->scene();
    CHECK(scene.bounds().low.y() == Approx(0.02));
    CHECK(scene.center_of_mass().x() == Approx(0.0).margin(1e-12));
    CHECK((*trial)->settling());
}

TEST_CASE("a creature starts 2 cm above the ground that is below it", "[simulator][terrain]") {
    TrialWorld world;
    world.environment.terrain.kind = "drawn";
    world.environment.terrain.points = "-9 3; 0 5; 9 3";
    auto trial = Trial::start(grown(test::crawler(test::creature_kinds().catalog), world),
                              test::creature_kinds(), world);
    REQUIRE(trial);
    const PhysicsScene& scene = (*trial)->scene();
    CHECK(scene.ground_gap() == Approx(0.02));
    CHECK(scene.bounds().low.y() > 3.0);
    CHECK(scene.center_of_mass().x() == Approx(0.0).margin(1e-12));
}

TEST_CASE("ground that is not always the same is drawn for each trial", "[simulator][terrain]") {
    const GenomePtr genome = test::crawler(test::creature_kinds().catalog);
    TrialWorld world;
    world.environment.terrain.kind = "rough";
    world.environment.terrain.height = 0.1;
    world.environment.terrain.pad = 1.0;
    world.light = {7, 0};
    const TrialWorld same = world;
    TrialWorld other = same;
    other.light.trial = 1;
    CHECK(with_drawn_ground(same) == same);
    CHECK(run(genome, same).digest == run(genome, other).digest);
    world.environment.terrain.same = false;
    other.environment.terrain.same = false;
    CHECK(with_drawn_ground(world) == with_drawn_ground(world));
    CHECK(with_drawn_ground(world).environment.terrain.seed !=
          with_drawn_ground(other).environment.terrain.seed);
    CHECK(with_drawn_ground(with_drawn_ground(world)) == with_drawn_ground(world));
}

TEST_CASE("the clock starts only once the creature has settled", "[simulator]") {
    const TrialRecord record = run(test::crawler(test::creature_kinds().catalog));
    CHECK(record.settle_time >= 0.4);
    CHECK(record.settle_time <= 3.0);
    CHECK(record.samples.front().bounds.low.y() == Approx(0.0).margin(2e-3));
}

TEST_CASE("without ground a trial starts at once", "[simulator]") {
    TrialWorld space;
    space.environment.has_ground = false;
    space.environment.gravity = 0.0;
    const TrialRecord record = run(test::crawler(test::creature_kinds().catalog), space);
    CHECK(record.settle_time == 0.0);
    CHECK(record.samples.front().center_of_mass.norm() < 1e-12);
    // Without external forces the centre of mass does not move.
    CHECK(record.samples.back().center_of_mass.norm() < 1e-9);
}

TEST_CASE("the same trial gives the same digest, another world another", "[simulator]") {
    const GenomePtr genome = test::crawler(test::creature_kinds().catalog);
    TrialWorld moon;
    moon.environment.gravity = 1.62;
    CHECK(run(genome).digest == run(genome).digest);
    CHECK(run(genome).digest != run(genome, moon).digest);
}

TEST_CASE("playing on after the end leaves the record as it was", "[simulator]") {
    auto trial = Trial::start(grown(test::crawler(test::creature_kinds().catalog)),
                              test::creature_kinds(), {});
    REQUIRE(trial);
    while ((*trial)->tick()) {
    }
    const TrialRecord before = (*trial)->record();
    for (int i = 0; i < 100; ++i)
        CHECK_FALSE((*trial)->tick());
    CHECK((*trial)->record().digest == before.digest);
    CHECK((*trial)->record().samples.size() == before.samples.size());
    CHECK((*trial)->time() > 15.0);
}

TEST_CASE("a trial of no duration is completed at once", "[simulator]") {
    TrialWorld world;
    world.trial.duration = 0.0;
    const TrialRecord record = run(test::crawler(test::creature_kinds().catalog), world);
    CHECK(record.outcome == Outcome::kCompleted);
    CHECK(record.samples.size() == 1);
}

TEST_CASE("the speed limit disqualifies a creature that is too fast", "[simulator]") {
    TrialWorld strict;
    strict.trial.max_part_speed = 0.3;
    const TrialRecord record = run(test::crawler(test::creature_kinds().catalog), strict);
    CHECK(record.outcome == Outcome::kDisqualified);
    CHECK(record.reason.find("faster") != std::string::npos);
}

TEST_CASE(
    "creatures with motors off settle lower than those that hold their pose, and move afterwards",
    "[simulator]") {
    TrialWorld slack;
    slack.trial.settle_motors_off = true;
    slack.environment.friction = 0.5;  // more of it keeps the flat body from drawing its ends in
    const auto held = run(test::crawler(test::creature_kinds().catalog));
    const auto settled = run(test::crawler(test::creature_kinds().catalog), slack);
    REQUIRE(settled.outcome == Outcome::kCompleted);
    CHECK(settled.settle_time > 0.4);
    const double high = held.samples.front().center_of_mass.y();
    const double low = settled.samples.front().center_of_mass.y();
    CAPTURE(high, low);
    CHECK(low < 0.8 * high);
    CHECK(settled.audit.gross_motor_work > 0.1);
}

TEST_CASE("without a settling phase, settling with motors off changes nothing", "[simulator]") {
    TrialWorld world;
    world.trial.settle_limit = 0.0;
    const auto usual = run(test::crawler(test::creature_kinds().catalog), world);
    world.trial.settle_motors_off = true;
    CHECK(run(test::crawler(test::creature_kinds().catalog), world).digest == usual.digest);
}
