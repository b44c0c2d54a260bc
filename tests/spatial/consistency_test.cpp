#include "planar/planar_scene.h"
#include "spatial/algebra.h"
#include "spatial/bodies.h"
#include "support/body_plans.h"

#include <catch2/catch.hpp>

#include <algorithm>
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
            // Planar parts touch one another; those in space do not yet.
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

namespace {

// Returns whether a part above the ground touches another, which those in space do not yet.
bool touches_itself(const PhysicsScene& scene) {
    for (std::size_t p = 0; p < scene.part_count(); ++p) {
        const Vec3 half = scene.part_half_extents(p);
        const Vec3 axis = scene.part_axis(p);
        const double lowest = scene.part_center(p).y() - half.x() * std::fabs(axis.y()) -
                              half.y() * std::fabs(axis.x());
        if (lowest < 0.01) continue;
        for (std::size_t face = 0; face < kFaceCount; ++face) {
            if (scene.face_touched(p, static_cast<Face>(face))) return true;
        }
    }
    return false;
}

}  // namespace

// C3, C4.
TEST_CASE("A planar body lands in space as it does in the plane") {
    constexpr double depth = 0.2;
    int compared = 0;
    double most = 0.0;
    double sum = 0.0;
    for (std::uint64_t creature = 0; creature < 40; ++creature) {
        RandomStream random(stream_seed({108, creature}));
        const int parts = random.between(2, 8);
        const BodyPlan plan = random_tree(random, parts, 0.2, 20.0, 0.0);
        Environment flat;
        Environment space = flat;
        space.density /= depth;
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
        for (int tick = 0; tick < 120 && after < 30 && !touches_itself(**planar); ++tick) {
            flail(**planar, plan, 1.0);
            flail(*solid, plan, 1.0);
            REQUIRE((*planar)->advance(kTestTick) == SceneStatus::kRunning);
            REQUIRE(solid->advance(kTestTick) == SceneStatus::kRunning);
            if (after > 0 || (*planar)->lowest_point() < 1e-3) ++after;
            apart = std::fmax(apart,
                              farthest(*solid, **planar, [](const Vec3& point) { return point; }));
        }
        if (after < 30) continue;
        ++compared;
        sum += apart;
        most = std::fmax(most, apart);
    }
    CAPTURE(compared, most, sum / compared);
    CHECK(compared > 20);
    CHECK(sum / compared < 1e-3);
    CHECK(most < 1e-2);
}

namespace {

// Returns the mirror image of a plan from front to back.
BodyPlan image_of(BodyPlan plan) {
    for (PlannedPart& part : plan.parts) {
        const Rotation& q = part.rest_pose.orientation;
        part.rest_pose.orientation = Rotation(q.w(), -q.x(), -q.y(), q.z());
        for (Vec3* point :
             {&part.rest_pose.position, &part.anchor_in_parent, &part.anchor_in_child})
            point->z() = -point->z();
        const auto turn = [&part](std::size_t degree, double& low, double& high) {
            if (part.motion != JointMotion::kTurn || part.axes[degree] == 2) return;
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
        if (part.motion != JointMotion::kTurn) continue;
        for (std::size_t d = 0; d < degrees_of(part); ++d) {
            const JointDegree degree{static_cast<std::uint16_t>(p), static_cast<std::uint8_t>(d)};
            if (part.axes[d] != 2) scene.set_target(degree, -scene.target(degree));
        }
    }
}

}  // namespace

// C8, C5 on the ground, where rounding grows with every impact.
TEST_CASE("On the ground neither the direction nor the side of a body matters") {
    double mirrored_most = 0.0;
    double turned_most = 0.0;
    for (std::uint64_t creature = 0; creature < 20; ++creature) {
        RandomStream random(stream_seed({109, creature}));
        const BodyPlan plan = random_solid(random, random.between(2, 10), 25000.0);
        const BodyPlan image = image_of(plan);
        const Rotation yaw = spatial::rotation_by(Vec3(0.0, random.uniform(0.2, 3.0), 0.0));
        const BodyPlan other = turned_plan(plan, yaw);
        const auto scene = make_solid(plan, spatial_ground(0.8, 0.2));
        const auto mirrored = make_solid(image, spatial_ground(0.8, 0.2));
        const auto turned = make_solid(other, spatial_ground(0.8, 0.2));
        for (const auto* each : {&scene, &mirrored, &turned})
            stand(**each);
        for (int tick = 0; tick < 120; ++tick) {
            swing(*scene, plan);
            swing_image(*mirrored, image);
            swing(*turned, other);
            for (const auto* each : {&scene, &mirrored, &turned})
                REQUIRE((*each)->advance(kTestTick) == SceneStatus::kRunning);
        }
        const double from_image = farthest(*scene, *mirrored, [](const Vec3& point) {
            return Vec3(point.x(), point.y(), -point.z());
        });
        const double from_turned =
            farthest(*scene, *turned, [&yaw](const Vec3& point) { return yaw * point; });
        mirrored_most = std::fmax(mirrored_most, from_image);
        turned_most = std::fmax(turned_most, from_turned);
    }
    CAPTURE(mirrored_most, turned_most);
    CHECK(mirrored_most < 5e-3);
    CHECK(turned_most < 5e-3);
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
