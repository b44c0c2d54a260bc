// The wall on one side of a trial: where it stands, that nobody crosses it, and who senses it.
#include "simulator/surroundings/side_wall.h"

#include "simulator/trial.h"
#include "support/catch.h"
#include "support/creatures.h"
#include "support/kinds.h"

#include <cmath>

using namespace cambrian;

namespace {

Environment walled() {
    Environment environment;
    environment.has_wall = true;
    return environment;
}

Bounds body_from(double low, double high) {
    Bounds bounds;
    bounds.add({low, 0.0, 0.0});
    bounds.add({high, 0.4, 0.0});
    return bounds;
}

// Returns the gap between the body and the wall.
double gap_of(const SideWall& wall, const Bounds& body) {
    return wall.side > 0 ? wall.box.low.x() - body.high.x() : body.low.x() - wall.box.high.x();
}

TrialWorld world_of(int trial, std::uint64_t seed) {
    TrialWorld world;
    world.environment = walled();
    world.light = {seed, trial};
    world.trial.stop_at_rest = false;
    return world;
}

std::unique_ptr<Trial> begin_trial(const GenomePtr& genome, const TrialWorld& world) {
    auto phenotype = std::make_shared<const Phenotype>(
        express(*genome, test::creature_kinds(), ExpressionSettings{}, world.scene));
    auto trial = Trial::start(std::move(phenotype), test::creature_kinds(), world);
    REQUIRE(trial);
    return std::move(*trial);
}

}  // namespace

TEST_CASE("two trials have the wall at the same distance on opposite sides", "[simulator][wall]") {
    const Environment environment = walled();
    const Bounds body = body_from(-0.3, 0.5);
    int right_first = 0;
    double least = 1e9;
    double greatest = 0.0;
    constexpr int pairs = 400;
    for (int pair = 0; pair < pairs; ++pair) {
        const SideWall first = draw_side_wall(environment, {7, 2 * pair}, body);
        const SideWall second = draw_side_wall(environment, {7, 2 * pair + 1}, body);
        CHECK(first.side == -second.side);
        const double gap = gap_of(first, body);
        CHECK(gap == Approx(gap_of(second, body)).epsilon(1e-12));
        least = std::fmin(least, gap);
        greatest = std::fmax(greatest, gap);
        right_first += first.side > 0 ? 1 : 0;
        CHECK(first.box.high.y() == kWallHeight);
        CHECK(first.box.low.y() < 0.0);
    }
    CHECK(least >= environment.wall_nearest);
    CHECK(least < environment.wall_nearest + 0.05);
    CHECK(greatest <= environment.wall_farthest);
    CHECK(greatest > environment.wall_farthest - 0.05);
    CHECK(std::abs(right_first - pairs / 2) < 50);  // five standard deviations
}

TEST_CASE("the distance to a wall is to its near face, and there is none behind",
          "[simulator][wall]") {
    const SideWall wall = draw_side_wall(walled(), {3, 0}, body_from(-0.5, 0.5));
    const double near = wall.side > 0 ? wall.box.low.x() : wall.box.high.x();
    const Vec3 before(near - 2.0 * wall.side, 0.3, 0.0);
    CHECK(distance_to_wall(wall.box, before, wall.side) == Approx(2.0));
    CHECK(std::isinf(distance_to_wall(wall.box, before, -wall.side)));
    CHECK(distance_to_wall(wall.box, wall.box.center, 1) == 0.0);
}

TEST_CASE("a crawler that comes to the wall stays before it", "[simulator][wall]") {
    const GenomePtr crawler = test::crawler(test::kind_catalog());
    int stopped = 0;
    for (int trial = 0; trial < 2; ++trial) {
        TrialWorld world = world_of(trial, 5);
        world.environment.wall_nearest = 0.1;
        world.environment.wall_farthest = 0.2;
        world.trial.duration = 30.0;
        const auto with = begin_trial(crawler, world);
        world.environment.has_wall = false;
        const auto without = begin_trial(crawler, world);
        while (with->tick() && without->tick()) {
        }
        REQUIRE(with->wall() != nullptr);
        CHECK(without->wall() == nullptr);
        const int side = with->record().wall_side;
        const Bounds body = with->scene().bounds();
        const double over = side > 0 ? body.high.x() - with->wall()->low.x()
                                     : with->wall()->high.x() - body.low.x();
        CHECK(over < 0.01);
        const double free = side * without->scene().center_of_mass().x();
        if (free > 1.0) {
            ++stopped;
            CHECK(side * with->scene().center_of_mass().x() < free - 0.5);
        }
    }
    CHECK(stopped == 1);  // it crawls to one side only
}

TEST_CASE("a trial with a wall goes on with the same bits from any moment", "[simulator][wall]") {
    const GenomePtr crawler = test::crawler(test::kind_catalog());
    TrialWorld world = world_of(1, 9);
    world.environment.wall_nearest = 0.1;
    world.environment.wall_farthest = 0.1;
    const auto trial = begin_trial(crawler, world);
    const Trial::State start = trial->save();
    while (trial->settling())
        trial->tick();
    for (int tick = 0; tick < 200; ++tick)
        trial->tick();
    const Trial::State middle = trial->save();
    while (trial->tick()) {
    }
    const std::uint64_t digest = trial->record().digest;
    for (const Trial::State* state : {&start, &middle}) {
        trial->restore(*state);
        CHECK((trial->wall() != nullptr) == (state == &middle));
        while (trial->tick()) {
        }
        CHECK(trial->record().digest == digest);
    }
}

TEST_CASE("a numb world hides its wall from those in it", "[simulator][wall]") {
    for (const bool numb : {false, true}) {
        TrialWorld world = world_of(0, 1);
        world.environment.numb = numb;
        const auto trial = begin_trial(test::crawler(test::kind_catalog()), world);
        while (trial->settling())
            trial->tick();
        const int side = trial->record().wall_side;
        const double distance = trial->surroundings().obstacle(Vec3::Zero(), side);
        CHECK(std::isinf(distance) == numb);
        CHECK(std::isinf(trial->surroundings().obstacle(Vec3::Zero(), -side)));
    }
}
