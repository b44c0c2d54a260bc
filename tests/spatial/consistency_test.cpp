#include "planar/planar_scene.h"
#include "spatial/algebra.h"
#include "spatial/bodies.h"
#include "support/body_plans.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace cambrian {
namespace {

SceneSettings exact_settings() {
    SceneSettings settings;
    settings.integrator = "dormand-prince";
    settings.tolerance = 1e-8;
    settings.max_evaluations = 1e6;
    return settings;
}

void swing_for(PhysicsScene& scene, const BodyPlan& plan, int ticks) {
    for (int tick = 0; tick < ticks; ++tick) {
        swing(scene, plan);
        REQUIRE(scene.advance(1.0 / 60) == SceneStatus::kRunning);
    }
}

// Returns the greatest distance of corresponding parts, where `place` takes points of the first
// scene to the second.
template <class Place>
double farthest(const PhysicsScene& first, const PhysicsScene& second, Place place) {
    double most = 0.0;
    for (std::size_t p = 0; p < first.part_count(); ++p) {
        for (const double share : {-1.0, 0.0, 1.0}) {
            const Vec3 at = place(point_on_axis(first, p, share));
            most = std::fmax(most, (at - point_on_axis(second, p, share)).norm());
        }
    }
    return most;
}

// Returns whether parts touch one another or a joint is near its stop.
bool touches(const PhysicsScene& scene) {
    for (std::size_t p = 0; p < scene.part_count(); ++p) {
        if (std::fabs(scene.joint_coordinate(p)) > 2.4) return true;
        for (std::size_t face = 0; face < kFaceCount; ++face) {
            if (scene.face_touched(p, static_cast<Face>(face))) return true;
        }
    }
    return false;
}

}  // namespace

// C1, C2. A body of boxes with one depth, whose density and drag are those of the plane over that
// depth, moves in its plane as planar physics has it.
TEST_CASE("A planar body moves in space as it does in the plane") {
    constexpr double depth = 0.2;
    int all_ticks = 0;
    for (const bool wet : {false, true}) {
        for (std::uint64_t creature = 0; creature < 20; ++creature) {
            RandomStream random(stream_seed({103, creature}));
            const int parts = random.between(3, 12);
            const BodyPlan targets = random_tree(random, parts, 0.2, 20.0, 0.0);
            BodyPlan plan = targets;
            for (PlannedPart& part : plan.parts) {
                part.limit_low = -2.6;
                part.limit_high = 2.6;
            }
            Environment flat = wet ? open_water() : empty_space();
            Environment space = flat;
            for (double* number :
                 {&space.density, &space.viscosity_linear, &space.viscosity_quadratic})
                *number /= depth;
            auto planar = planar_scene_kind().make(plan, flat, exact_settings());
            REQUIRE(planar);
            const auto solid = make_solid(with_depth(plan, depth), space, exact_settings());
            CHECK(solid->mass() == Approx((*planar)->mass()).epsilon(1e-12));
            // Touching lets errors grow.
            double apart = 0.0;
            double out = 0.0;
            int ticks = 0;
            for (; ticks < 300 && !touches(**planar); ++ticks) {
                apart = farthest(*solid, **planar, [](const Vec3& point) { return point; });
                flail(**planar, targets, 1.0);
                flail(*solid, targets, 1.0);
                REQUIRE((*planar)->advance(kTestTick) == SceneStatus::kRunning);
                REQUIRE(solid->advance(kTestTick) == SceneStatus::kRunning);
            }
            for (std::size_t p = 0; p < plan.parts.size(); ++p) {
                const Twist twist = solid->part_twist(p);
                out = std::fmax(out, std::fabs(solid->part_center(p).z()));
                out = std::fmax(out, twist.angular.head<2>().cwiseAbs().maxCoeff());
            }
            all_ticks += ticks;
            CAPTURE(wet, parts, apart, out);
            CHECK(apart < 1e-6);
            CHECK(out < 1e-9);
        }
    }
    CHECK(all_ticks > 1500);
}

// C3, with contact between parts, too.
TEST_CASE("A planar body lands in space as it does in the plane") {
    constexpr double depth = 0.2;
    int close = 0;
    double most = 0.0;
    for (std::uint64_t creature = 0; creature < 40; ++creature) {
        RandomStream random(stream_seed({108, creature}));
        const int parts = random.between(2, 8);
        const BodyPlan plan = random_tree(random, parts, 0.2, 20.0, 0.0);
        Environment flat;
        Environment space = flat;
        space.density /= depth;
        space.self_contact = true;
        SceneSettings fine;
        fine.tolerance = 1e-5;
        fine.contact_step = 1.0 / 960;
        auto planar = planar_scene_kind().make(plan, flat, fine);
        REQUIRE(planar);
        const auto solid = make_solid(with_depth(plan, depth), space, fine);
        stand(**planar);
        stand(*solid);
        double apart = 0.0;
        int after = 0;
        for (int tick = 0; tick < 120 && after < 30; ++tick) {
            flail(**planar, plan, 1.0);
            flail(*solid, plan, 1.0);
            REQUIRE((*planar)->advance(kTestTick) == SceneStatus::kRunning);
            REQUIRE(solid->advance(kTestTick) == SceneStatus::kRunning);
            if (after > 0 || (*planar)->lowest_point() < 1e-3) ++after;
            apart = std::fmax(apart,
                              farthest(*solid, **planar, [](const Vec3& point) { return point; }));
        }
        if (after == 30 && apart < 1e-3) ++close;
        most = std::fmax(most, apart);
    }
    // Where a corner hits a little later, the next contacts are others (spatial/README.md 8).
    CAPTURE(close, most);
    CHECK(close >= 30);
    CHECK(most < 0.05);
}

namespace {

constexpr double kBoxHalf = 0.1;  // m, of the box's height

// A box flat on the ground or above it (m), in the plane or lifted, with a speed along it (m/s).
std::unique_ptr<PhysicsScene> start_flat_box(Environment environment, bool lifted, double height,
                                             double speed) {
    constexpr double depth = 0.3;
    const BodyPlan plan = one_box(0.2, kBoxHalf, 0.0, height + kBoxHalf);
    if (lifted) environment.density /= depth;
    auto made = (lifted ? spatial_scene_kind() : planar_scene_kind())
                    .make(lifted ? with_depth(plan, depth) : plan, environment, {});
    REQUIRE(made);
    SceneMotion motion = (*made)->motion();
    motion.speeds[lifted ? 3 : 1] = speed;
    REQUIRE((*made)->begin_at(motion));
    return *std::move(made);
}

constexpr double kAtRest = 0.5e-3;  // m, the height of what rests

}  // namespace

// C4. The tolerances are those of the plane's own tests.
TEST_CASE("A planar box slides and bounces in space as it does in the plane") {
    const auto places = [](const Environment& environment, double height, double speed, int ticks) {
        std::array<Vec3, 2> ends;
        for (const bool lifted : {false, true}) {
            const auto scene = start_flat_box(environment, lifted, height, speed);
            run_ticks(*scene, ticks);
            ends[lifted ? 1 : 0] = scene->center_of_mass();
        }
        CHECK(std::fabs(ends[1].z()) < 1e-9);
        return ends;
    };
    Environment environment;
    environment.friction = 0.5;
    const auto stopped = places(environment, kAtRest, 3.0, 120);
    CHECK(stopped[1].x() == Approx(stopped[0].x()).epsilon(2e-4));
    for (const double share : {0.5, 0.9, 1.1, 1.5}) {
        Environment slope = environment;
        slope.gravity_direction = -90.0 + std::atan(share * 0.5) * 180.0 / kPi;
        const auto ends = places(slope, kAtRest, 0.0, 240);
        CAPTURE(share);
        CHECK(ends[1].x() == Approx(ends[0].x()).epsilon(1e-4).margin(1e-5));
        CHECK((ends[0].x() > 0.1) == (share > 1.0));
    }
    for (const double elasticity : {0.5, 0.8, 1.0}) {
        environment.elasticity = elasticity;
        const auto planar = start_flat_box(environment, false, 1.0, 0.0);
        const auto solid = start_flat_box(environment, true, 1.0, 0.0);
        double apart = 0.0;
        for (int tick = 0; tick < 90; ++tick) {
            run_ticks(*planar, 1);
            run_ticks(*solid, 1);
            apart = std::fmax(apart, (planar->center_of_mass() - solid->center_of_mass()).norm());
        }
        CAPTURE(elasticity, apart);
        CHECK(apart < 2e-3);  // either bounces within 1 mm of the truth
    }
}

namespace {

bool is_turning(const PlannedPart& part) {
    return part.motion == JointMotion::kTurn || part.motion == JointMotion::kBall;
}

// Returns the mirror image of a plan from front to back.
BodyPlan image_of(BodyPlan plan) {
    for (PlannedPart& part : plan.parts) {
        const Rotation& q = part.rest_pose.orientation;
        part.rest_pose.orientation = Rotation(q.w(), -q.x(), -q.y(), q.z());
        for (Vec3* point :
             {&part.rest_pose.position, &part.anchor_in_parent, &part.anchor_in_child})
            point->z() = -point->z();
        const auto turn = [&part](std::size_t degree, double& low, double& high) {
            if (!is_turning(part) || part.axes[degree] == 2) return;
            low = std::exchange(high, -low);
            low = -low;
        };
        turn(0, part.limit_low, part.limit_high);
        for (std::size_t d = 1; d < part.degree_count; ++d)
            turn(d, part.further[d - 1].low, part.further[d - 1].high);
    }
    return plan;
}

// Sets targets like swing(), those of turned over hinges against it.
void swing_image(PhysicsScene& scene, const BodyPlan& plan) {
    swing(scene, plan);
    for (std::size_t p = 1; p < plan.parts.size(); ++p) {
        const PlannedPart& part = plan.parts[p];
        if (!is_turning(part)) continue;
        for (std::size_t d = 0; d < degrees_of(part); ++d) {
            const JointDegree degree{static_cast<std::uint16_t>(p), static_cast<std::uint8_t>(d)};
            if (part.axes[d] != 2) scene.set_target(degree, -scene.target(degree));
        }
    }
}

}  // namespace

// C8, C5 on the ground or with contact between parts, where rounding grows with every impact.
TEST_CASE("On the ground neither the direction nor the side of a body matters") {
    const bool touch = GENERATE(false, true);
    Environment environment = touch ? spatial_water() : spatial_ground(0.8, 0.2);
    environment.self_contact = touch;
    double mirrored_most = 0.0;
    double turned_most = 0.0;
    int touches = 0;
    for (std::uint64_t creature = 0; creature < 20; ++creature) {
        RandomStream random(stream_seed({109, creature}));
        const BodyPlan plan = random_solid(random, random.between(2, 10), 25000.0);
        const BodyPlan image = image_of(plan);
        const Rotation yaw = spatial::rotation_by(Vec3(0.0, random.uniform(0.2, 3.0), 0.0));
        const BodyPlan other = turned_plan(plan, yaw);
        const auto scene = make_solid(plan, environment);
        const auto mirrored = make_solid(image, environment);
        const auto turned = make_solid(other, environment);
        for (const auto* each : {&scene, &mirrored, &turned})
            stand(**each);
        for (int tick = 0; tick < 120; ++tick) {
            swing(*scene, plan);
            swing_image(*mirrored, image);
            swing(*turned, other);
            for (const auto* each : {&scene, &mirrored, &turned})
                REQUIRE((*each)->advance(kTestTick) == SceneStatus::kRunning);
        }
        touches += touch && scene->audit().contact_work < 0.0 ? 1 : 0;
        const double from_image = farthest(*scene, *mirrored, [](const Vec3& point) {
            return Vec3(point.x(), point.y(), -point.z());
        });
        const double from_turned =
            farthest(*scene, *turned, [&yaw](const Vec3& point) { return yaw * point; });
        mirrored_most = std::fmax(mirrored_most, from_image);
        turned_most = std::fmax(turned_most, from_turned);
    }
    CAPTURE(touch, touches, mirrored_most, turned_most);
    CHECK(touches >= (touch ? 5 : 0));
    CHECK(mirrored_most < 5e-3);
    CHECK(turned_most < 1e-2);
}

// C5.
TEST_CASE("Motion does not depend on the direction that a body faces") {
    for (std::uint64_t creature = 0; creature < 20; ++creature) {
        RandomStream random(stream_seed({104, creature}));
        const BodyPlan plan = random_solid(random, random.between(3, 12), 25000.0);
        const Rotation yaw = spatial::rotation_by(Vec3(0.0, random.uniform(0.2, 3.0), 0.0));
        const BodyPlan other = turned_plan(plan, yaw);
        const auto scene = make_solid(plan, spatial_water());
        const auto turned = make_solid(other, spatial_water());
        swing_for(*scene, plan, 300);
        swing_for(*turned, other, 300);
        const double apart =
            farthest(*scene, *turned, [&yaw](const Vec3& point) { return yaw * point; });
        CAPTURE(creature, apart);
        CHECK(apart < 1e-9);
    }
}

// C6, C7.
TEST_CASE("Motion does not depend on the place or the speed of the whole") {
    RandomStream random(stream_seed({105}));
    const BodyPlan plan = random_solid(random, 8, 25000.0);
    for (const bool wet : {false, true}) {
        const Environment environment = wet ? spatial_water() : weightless();
        const auto scene = make_solid(plan, environment);
        const auto moved = make_solid(plan, environment);
        moved->translate(Vec3(1000.0, -300.0, 500.0));
        const auto moving = make_solid(plan, environment);
        SceneMotion motion = moving->motion();
        motion.speeds[motion.speeds.size() - 3] += 5.0;
        REQUIRE(moving->begin_at(motion));
        for (const auto* each : {&scene, &moved, &moving})
            swing_for(**each, plan, 300);
        for (std::size_t p = 0; p < plan.parts.size(); ++p) {
            const Rotation here = scene->part_pose(p).orientation;
            CHECK(here.angularDistance(moved->part_pose(p).orientation) < 1e-12);
            CHECK(std::fabs(scene->joint_coordinate(p) - moved->joint_coordinate(p)) < 1e-12);
            if (wet) continue;
            CHECK(here.angularDistance(moving->part_pose(p).orientation) < 1e-12);
            CHECK(std::fabs(scene->joint_coordinate(p) - moving->joint_coordinate(p)) < 1e-12);
        }
    }
}

TEST_CASE("A saved state goes on with the same bits") {
    RandomStream random(stream_seed({106}));
    const BodyPlan plan = random_solid(random, 9, 25000.0);
    const auto scene = make_solid(plan, spatial_water());
    swing_for(*scene, plan, 60);
    const auto saved = scene->save();
    const auto digest = [&] {
        swing_for(*scene, plan, 120);
        Hash64 hash;
        scene->add_to_digest(hash);
        return hash.value();
    };
    const std::uint64_t first = digest();
    scene->restore(*saved);
    CHECK(digest() == first);
}

}  // namespace cambrian
