// A light in the world of a trial: where it is and goes, and what a trial records of it.
#include "genome/founders/random_genome.h"
#include "simulator/surroundings/light_source.h"
#include "simulator/trial.h"
#include "support/catch.h"
#include "support/creatures.h"
#include "support/kinds.h"

#include <cmath>
#include <set>

using namespace cambrian;

namespace {

constexpr double kLength = 0.7;  // m

Environment lit(const std::string& motion, bool has_ground = false) {
    Environment environment;
    environment.has_ground = has_ground;
    environment.gravity = has_ground ? kEarthGravity : 0.0;
    environment.viscosity_quadratic = 1.0;
    environment.has_light = true;
    environment.light_motion = motion;
    return environment;
}

// Places at the start of each leg, seen by a creature that stays at a point.
std::vector<Vec3> jumps(const Environment& environment, const LightDraw& draw, const Vec3& center) {
    LightSource light(environment, draw);
    std::vector<Vec3> places;
    for (std::uint64_t tick = 0; tick < 5 * light.leg_ticks(); ++tick) {
        light.move(tick, center, kLength);
        if (tick % light.leg_ticks() == 0) places.push_back(light.place());
        CHECK(light.place() == places.back());
    }
    return places;
}

std::unique_ptr<Trial> begin(const GenomePtr& genome, const TrialWorld& world) {
    auto phenotype = std::make_shared<const Phenotype>(
        express(*genome, test::creature_kinds(), ExpressionSettings{}, world.scene));
    auto trial = Trial::start(std::move(phenotype), test::creature_kinds(), world);
    REQUIRE(trial);
    return std::move(*trial);
}

TrialRecord run(const GenomePtr& genome, const Environment& environment) {
    TrialWorld world;
    world.environment = environment;
    world.light.seed = 4;
    const auto trial = begin(genome, world);
    while (trial->tick()) {
    }
    REQUIRE(trial->record().outcome == Outcome::kCompleted);
    return trial->take_record();
}

}  // namespace

TEST_CASE("light falls with the square of the distance over its reach", "[simulator][light]") {
    Environment environment = lit("still");
    environment.light_brightness = 3.0;
    environment.light_reach = 2.0;
    const LightSource light(environment, {});
    const Vec3 place = light.place();
    CHECK(place == Vec3(3.0, 1.0, 0.0));
    struct Row {
        double distance, intensity;
    };
    for (const Row& row : {Row{2.0, 1.5}, Row{4.0, 0.6}, Row{6.0, 0.3}}) {
        const Light seen = light.at(place - Vec3(0.0, row.distance, 0.0));
        CHECK(seen.intensity == Approx(row.intensity));
        CHECK((seen.direction - Vec3::UnitY()).norm() < 1e-15);
    }
    CHECK(light.at(place).intensity == 3.0);
    CHECK(light.at(place).direction == Vec3::Zero());
    environment.light_brightness = 0.0;
    CHECK(LightSource(environment, {}).at(Vec3::Zero()).direction == Vec3::Zero());
    environment.has_light = false;
    CHECK(LightSource(environment, {}).at(Vec3::Zero()).intensity == 0.0);
}

TEST_CASE("jumps are as far and as frequent as settings say", "[simulator][light]") {
    Environment environment = lit("jumping");
    environment.light_nearest = 1.0;
    environment.light_farthest = 2.0;
    environment.light_period = 10.0;
    CHECK(LightSource(environment, {}).leg_ticks() == 600);
    for (const Vec3& place : jumps(environment, {7, 0}, Vec3::Zero())) {
        CHECK(place.norm() / kLength >= 1.0 - 1e-12);
        CHECK(place.norm() / kLength <= 2.0 + 1e-12);
    }
    const TrialRecord record =
        run(test::flapper(test::creature_kinds().catalog, 1.0, 0.5), environment);
    REQUIRE(record.legs.all().size() == 2);  // of 15 s
    CHECK(record.legs.all()[0].ticks == 600);
    CHECK(record.legs.all()[1].ticks == 300);
}

TEST_CASE("jumps are 3 to 6 rest lengths from where the creature is", "[simulator][light]") {
    std::set<double> distances;
    const Vec3 center(8.0, 2.0, 0.0);
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        for (const Vec3& place : jumps(lit("jumping"), {seed, 0}, center)) {
            const double distance = (place - center).norm() / kLength;
            CHECK(distance >= 3.0 - 1e-12);
            CHECK(distance <= 6.0 + 1e-12);
            distances.insert(distance);
        }
        for (const Vec3& place : jumps(lit("jumping", true), {seed, 0}, center)) {
            const double across = std::fabs(place.x() - center.x()) / kLength;
            CHECK(across >= 3.0 - 1e-12);
            CHECK(across <= 6.0 + 1e-12);
            CHECK(place.y() == 0.3 * kLength);
        }
    }
    CHECK(distances.size() == 250);
}

TEST_CASE("a light that hunts jumps, follows who flees, and stays where it is passed",
          "[simulator][light]") {
    for (const bool has_ground : {false, true}) {
        const Environment environment = lit("hunting", has_ground);
        LightSource light(environment, {3, 0});
        Vec3 at(1.0, 0.4, 0.0);
        light.move(0, at, kLength);
        CHECK(light.place() == jumps(lit("jumping", has_ground), {3, 0}, at).front());
        const auto distance = [&] {
            Vec3 way = light.place() - at;
            if (has_ground) way.y() = 0.0;
            return way.norm();
        };
        const double first = distance();
        const double height = light.place().y();
        const Vec3 away = (at - light.place()).normalized();
        for (std::uint64_t tick = 1; tick < 100; ++tick) {
            at += 0.01 * away;
            light.move(tick, at, kLength);
            CHECK(distance() == Approx(first));
            if (has_ground) CHECK(light.place().y() == Approx(height));
        }
        const Vec3 stayed = light.place();
        at -= 0.2 * first * away;
        light.move(100, at, kLength);
        CHECK(light.place() == stayed);
        light.move(light.leg_ticks(), at, kLength);
        CHECK(light.place() != stayed);
    }
}

TEST_CASE("trials of a pair are mirror images, those of another pair are not",
          "[simulator][light]") {
    for (const bool has_ground : {false, true}) {
        int same = 0;
        for (std::uint64_t seed = 0; seed < 20; ++seed) {
            const auto even = jumps(lit("jumping", has_ground), {seed, 2}, Vec3::Zero());
            const auto odd = jumps(lit("jumping", has_ground), {seed, 3}, Vec3::Zero());
            const auto other = jumps(lit("jumping", has_ground), {seed, 4}, Vec3::Zero());
            CHECK(even == jumps(lit("jumping", has_ground), {seed, 2}, Vec3::Zero()));
            for (std::size_t leg = 0; leg < even.size(); ++leg) {
                CHECK(even[leg].x() == -odd[leg].x());
                CHECK(even[leg].y() == odd[leg].y());
                same += even[leg] == other[leg] ? 1 : 0;
            }
        }
        CHECK(same == 0);
    }
}

TEST_CASE("a light that wanders stays in its box and above ground", "[simulator][light]") {
    for (const bool has_ground : {false, true}) {
        Environment environment = lit("wandering", has_ground);
        environment.light_range = 1.5;
        LightSource light(environment, {7, 0});
        LightSource other(environment, {8, 0});
        double way = 0.0;
        for (std::uint64_t tick = 0; tick < 6000; ++tick) {
            const Vec3 before = light.place();
            light.move(tick, Vec3::Zero(), kLength);
            other.move(tick, Vec3::Zero(), kLength);
            way += (light.place() - before).norm();
            REQUIRE(std::fabs(light.place().x() - 3.0) <= 1.5);
            REQUIRE(std::fabs(light.place().y() - 1.0) <= 1.5);
            if (has_ground) REQUIRE(light.place().y() >= 0.0);
        }
        CHECK(way > 20.0);
        CHECK(way < 200.0);
        CHECK((light.place() - other.place()).norm() > 1e-3);
    }
    Environment fixed = lit("wandering");
    fixed.light_range = 0.0;
    LightSource light(fixed, {7, 0});
    light.move(0, Vec3::Zero(), kLength);
    CHECK(light.place() == Vec3(3.0, 1.0, 0.0));
}

TEST_CASE("what is changed by hand moves the light there", "[simulator][light]") {
    Environment environment = lit("wandering");
    LightSource light(environment, {7, 0});
    for (std::uint64_t tick = 0; tick < 60; ++tick)
        light.move(tick, Vec3::Zero(), kLength);
    const Vec3 wandered = light.place();
    environment.gravity = 1.0;
    light.set_environment(environment);
    CHECK(light.place() == wandered);
    environment.light_x = -2.0;
    light.set_environment(environment);
    CHECK(light.place() == Vec3(-2.0, 1.0, 0.0));
}

TEST_CASE("a creature does not rest while a light can still move", "[simulator][light][rest]") {
    const GenomePtr dreamer = test::dreamer(test::creature_kinds().catalog);
    CHECK(run(dreamer, lit("still", true)).computed_time < 5.0);
    CHECK(run(dreamer, lit("jumping", true)).computed_time == Approx(15.0));
    CHECK(run(dreamer, lit("wandering", true)).computed_time == Approx(15.0));
    CHECK(run(dreamer, lit("hunting", true)).computed_time == Approx(15.0));
    Environment off = lit("jumping", true);
    off.has_light = false;
    CHECK(run(dreamer, off).computed_time < 5.0);
}

TEST_CASE("a trial records how the light was followed, leg by leg", "[simulator][light]") {
    const GenomePtr dreamer = test::dreamer(test::creature_kinds().catalog);
    for (const char* motion : {"still", "jumping"}) {
        const TrialRecord record = run(dreamer, lit(motion, true));
        REQUIRE(record.legs.all().size() == 3);
        for (const LightLeg& leg : record.legs.all()) {
            CHECK(leg.end == Approx(leg.start).margin(0.05));
            CHECK(leg.mean == Approx(leg.start).margin(0.05));
            CHECK(leg.nearest <= std::min(leg.start, leg.end));
        }
    }
    Environment dark;
    CHECK(run(dreamer, dark).legs.all().empty());
}

TEST_CASE("a trial saved and restored finds the light where it was, to the bit",
          "[simulator][light]") {
    FounderSettings founders;
    for (const ChannelEntry& channel : test::creature_kinds().catalog.channels)
        founders.channels[channel.id] = true;
    RandomStream stream(stream_seed({21, 73}));
    for (const char* motion : {"jumping", "wandering"}) {
        for (int i = 0; i < 10; ++i) {
            TrialWorld world;
            world.environment = lit(motion);
            world.light = {9, 1};
            const auto trial = begin(std::make_shared<const Genome>(random_genome(
                                         founders, test::creature_kinds().catalog, stream)),
                                     world);
            for (int tick = 0; tick < 250; ++tick)
                trial->tick();
            const Trial::State state = trial->save();
            const auto go_on = [&] {
                for (int tick = 0; tick < 200; ++tick)
                    trial->tick();
                Hash64 digest;
                trial->scene().add_to_digest(digest);
                const Vec3 place = trial->surroundings().source().place();
                digest.add(place.x());
                digest.add(place.y());
                for (const LightLeg& leg : trial->record().legs.all())
                    digest.add(leg.mean);
                return digest.value();
            };
            const std::uint64_t first = go_on();
            trial->restore(state);
            CHECK(go_on() == first);
        }
    }
}
