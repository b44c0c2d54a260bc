#include "spatial/algebra.h"
#include "spatial/bodies.h"

#include <catch2/catch.hpp>
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace cambrian {
namespace {

const Vec3 kBox(0.2, 0.1, 0.15);

// Returns the greatest speed of a box, with 0.1 m/s for a spin of 1 rad/s.
double speed_of(const PhysicsScene& scene) {
    const Twist twist = scene.part_twist(0);
    return std::fmax(twist.linear.norm(), 0.1 * twist.angular.norm());
}

}  // namespace

// A14.
TEST_CASE("A sliding box stops straight ahead after the way that friction allows") {
    const auto scene = make_solid(one_solid(kBox), spatial_ground(0.5, 0.0));
    const double heading = 0.7;
    begin_box(*scene, {.place = {0.0, 0.1005, 0.0},
                       .velocity = 3.0 * Vec3(std::cos(heading), 0.0, std::sin(heading))});
    run_ticks(*scene, 90);
    const Vec3 end = scene->center_of_mass();
    const double way = std::hypot(end.x(), end.z());
    const double expected = 9.0 / (2.0 * 0.5 * kEarthGravity);
    const double aside = std::atan2(end.z(), end.x()) - heading;
    const SceneAudit& audit = scene->audit();
    CAPTURE(way, expected, aside, audit.contact_work, audit.evaluations, audit.fallbacks,
            audit.energy_residual);
    CHECK(std::fabs(way / expected - 1.0) < 2e-4);
    CHECK(std::fabs(aside) < 1e-6);
    CHECK(audit.contact_work == Approx(-0.5 * scene->mass() * 9.0).epsilon(1e-4));
    CHECK(std::fabs(audit.energy_residual) < 1e-6 * scene->mass());
    CHECK(audit.fallbacks == 0);
    CHECK(speed_of(*scene) < 1e-6);
}

// A15.
TEST_CASE("A box on a slope rests or slides as Coulomb's law has it") {
    for (const double steepness : {0.5, 0.9, 1.1, 1.5}) {
        Environment slope = spatial_ground(0.5, 0.0);
        const double angle = std::atan(steepness * 0.5);
        slope.gravity_direction = -90.0 + angle * 180.0 / kPi;
        const auto scene = make_solid(one_solid(kBox), slope);
        begin_box(*scene, {.place = {0.0, 0.1005, 0.0},
                           .attitude = spatial::rotation_by(Vec3(0.0, 0.4, 0.0))});
        run_ticks(*scene, 240);
        const Vec3 end = scene->center_of_mass();
        const double way = std::hypot(end.x(), end.z());
        const double pull = kEarthGravity * (std::sin(angle) - 0.5 * std::cos(angle));
        const double expected = steepness > 1.0 ? 0.5 * pull * 16.0 : 0.0;
        CAPTURE(steepness, way, expected);
        if (steepness > 1.0)
            CHECK(std::fabs(way / expected - 1.0) < 1e-4);
        else
            CHECK(way < 1e-5);
    }
}

// A16.
TEST_CASE("A box that falls flat bounces to the height that its elasticity leaves") {
    for (const double elasticity : {0.0, 0.5, 0.8, 1.0}) {
        const auto scene =
            make_solid(one_solid(Vec3(0.1, 0.1, 0.1)), spatial_ground(0.8, elasticity));
        begin_box(*scene, {.place = {0.0, 1.1, 0.0}});
        double top = 0.0;
        bool rose = false;
        for (int tick = 0; tick < 180; ++tick) {
            run_ticks(*scene, 1);
            const double rate = scene->center_of_mass_velocity().y();
            if (rose && rate < 0.0) break;
            if (rate <= 0.0) continue;
            rose = true;
            top = scene->center_of_mass().y() - 0.1 + rate * rate / (2.0 * kEarthGravity);
        }
        CAPTURE(elasticity, top);
        CHECK(std::fabs(top - elasticity * elasticity) < 1e-3);
        CHECK(scene->audit().positive_work < 2e-6 * scene->mass() * kEarthGravity);
    }
}

// A17.
TEST_CASE("A plate that slides and spins stops doing both at once") {
    const auto scene = make_solid(one_solid(Vec3(0.3, 0.01, 0.3)), spatial_ground(0.5, 0.0));
    begin_box(*scene,
              {.place = {0.0, 0.0105, 0.0}, .velocity = {2.0, 0.0, 0.0}, .spin = {0.0, 6.0, 0.0}});
    int slid = 0;
    int spun = 0;
    for (int tick = 1; tick <= 180; ++tick) {
        run_ticks(*scene, 1);
        const Twist twist = scene->part_twist(0);
        if (twist.linear.norm() > 0.01) slid = tick;
        if (0.3 * twist.angular.norm() > 0.01) spun = tick;
    }
    CAPTURE(slid, spun);
    CHECK(slid > 20);
    CHECK(std::abs(slid - spun) <= 2);
    CHECK(speed_of(*scene) < 1e-6);
}

// A18.
TEST_CASE("Boxes that tumble gain no energy and come to rest") {
    constexpr int boxes = 300;
    double most_gain = 0.0;
    double most_work = 0.0;
    double most_residual = 0.0;
    double deepest = 0.0;
    double latest = 0.0;
    double fastest = 0.0;
    double farthest = 0.0;
    std::uint64_t evaluations = 0;
    std::uint64_t fallbacks = 0;
    for (std::uint64_t box = 0; box < boxes; ++box) {
        RandomStream random(stream_seed({112, box}));
        const Vec3 half{random.uniform(0.03, 0.4), random.uniform(0.03, 0.25),
                        random.uniform(0.03, 0.25)};
        const double friction = 0.4 * static_cast<double>(box % 4);
        const double elasticity = 0.3 * static_cast<double>(box / 4 % 3);
        const auto scene = make_solid(one_solid(half), spatial_ground(friction, elasticity));
        const auto vector = [&random](double size) {
            return Vec3{random.uniform(-size, size), random.uniform(-size, size),
                        random.uniform(-size, size)};
        };
        SolidMotion motion;
        motion.place = {0.0, random.uniform(0.6, 1.5), 0.0};
        motion.attitude = spatial::rotation_by(vector(1.7));
        motion.velocity = vector(2.0);
        motion.spin = vector(4.6);
        begin_box(*scene, motion);
        const double weight = scene->mass() * kEarthGravity;
        const double start = scene->energy();
        double before = start;
        double rest = 0.0;
        Vec3 late = Vec3::Zero();
        for (int tick = 1; tick <= 600; ++tick) {
            run_ticks(*scene, 1);
            most_gain = std::fmax(most_gain, (scene->energy() - before) / weight);
            before = scene->energy();
            if (speed_of(*scene) > 1e-3) rest = tick / 60.0;
            if (tick == 480) late = scene->center_of_mass();
        }
        const SceneAudit& audit = scene->audit();
        most_work = std::fmax(most_work, audit.positive_work / start);
        most_residual = std::fmax(most_residual, std::fabs(audit.energy_residual) / start);
        deepest = std::fmax(deepest, audit.max_penetration);
        evaluations += audit.evaluations;
        fallbacks += audit.fallbacks;
        if (friction == 0.0) continue;  // slides on
        latest = std::fmax(latest, rest);
        fastest = std::fmax(fastest, speed_of(*scene));
        farthest = std::fmax(farthest, (scene->center_of_mass() - late).norm());
    }
    const std::string figures = fmt::format(
        "{} boxes: gain in a tick {:.1e} m of weight, positive work {:.1e} of the energy, residual "
        "{:.1e}, {:.2f} mm deep, rest after {:.2f} s, then {:.1e} m/s and {:.1e} m; {} evaluations "
        "a second, {} fallbacks",
        boxes, most_gain, most_work, most_residual, 1e3 * deepest, latest, fastest, farthest,
        evaluations / (10 * boxes), fallbacks);
    INFO(figures);
    CHECK(most_gain < 1e-3);
    CHECK(most_work < 0.01);
    CHECK(most_residual < 5e-3);
    CHECK(deepest < 3e-3);
    CHECK(latest < 6.0);
    CHECK(fastest < 1e-6);
    CHECK(farthest < 1e-6);
}

}  // namespace cambrian
