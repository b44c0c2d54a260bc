#include "math/elementary.h"
#include "spatial/algebra.h"
#include "spatial/bodies.h"

#include <catch2/catch.hpp>
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace cambrian {
namespace {

Environment touching(Environment environment) {
    environment.self_contact = true;
    return environment;
}

// Joins a part's proximal end to a point of its parent.
PlannedPart& add_limb(BodyPlan& plan, int parent, const Vec3& anchor, const Rotation& attitude,
                      const Vec3& half) {
    PlannedPart part;
    part.half_extents = half;
    part.parent = parent;
    part.motion = JointMotion::kTurn;
    part.anchor_in_parent = anchor;
    part.anchor_in_child = Vec3(-half.x(), 0.0, 0.0);
    part.rest_pose.orientation = attitude;
    part.rest_pose.position =
        transform(plan.parts[static_cast<std::size_t>(parent)].rest_pose, anchor) +
        attitude * Vec3(half.x(), 0.0, 0.0);
    plan.parts.push_back(part);
    return plan.parts.back();
}

constexpr double kReach = 0.5;      // m, from the hinge of an arm to its end
constexpr double kWidth = 0.04;     // m, half of the arm's
constexpr double kBetween = 0.46;   // m, from the hinge to the face of the other arm
constexpr double kStrength = 20.0;  // N m

// A bar with two arms that stand up from it. The first folds onto the second, which stands fast.
BodyPlan folding_arms() {
    const Rotation up = spatial::rotation_by(Vec3(0.0, 0.0, 0.5 * kPi));
    BodyPlan plan = one_solid(Vec3(0.3, 0.05, 0.1));
    PlannedPart& folded = add_limb(plan, 0, {-0.25, 0.05, 0.0}, up, {0.5 * kReach, kWidth, 0.06});
    folded.limit_low = -1.5;
    folded.limit_high = 1.5;
    folded.max_effort = kStrength;
    add_limb(plan, 0, {kBetween - 0.25 + kWidth, 0.05, 0.0}, up, {0.25, kWidth, 0.1});
    return plan;
}

// A bar with two equal boxes that slide along it.
BodyPlan sliding_boxes() {
    BodyPlan plan = one_solid(Vec3(0.6, 0.05, 0.05));
    for (const double x : {-0.3, 0.3}) {
        PlannedPart& box =
            add_limb(plan, 0, {x - 0.1, 0.2, 0.0}, Rotation::Identity(), Vec3(0.1, 0.1, 0.1));
        box.motion = JointMotion::kSlide;
        box.limit_low = -0.5;
        box.limit_high = 0.5;
    }
    return plan;
}

double total_force(const PhysicsScene& scene) {
    std::vector<SceneContact> contacts;
    scene.list_contacts(contacts);
    double sum = 0.0;
    for (const SceneContact& contact : contacts)
        sum += contact.force;
    return sum;
}

// Throws a creature with random rates of its joints and of its spin.
void throw_limp(PhysicsScene& scene, RandomStream& random) {
    SceneMotion motion = scene.motion();
    for (std::size_t i = 0; i < motion.speeds.size(); ++i)
        motion.speeds[i] = i + 3 < motion.speeds.size() ? random.uniform(-3.0, 3.0) : 0.0;
    REQUIRE(scene.begin_at(motion));
}

}  // namespace

TEST_CASE("An arm in space that folds onto another one rests where geometry has it") {
    const double size = std::hypot(kReach, kWidth);
    const double angle = std::asin((kBetween - 0.5e-3) / size) - std::atan2(kWidth, kReach);
    const double lever = kReach * std::cos(angle) - kWidth * std::sin(angle);
    for (const double friction : {0.0, 0.8}) {
        Environment world = touching(weightless());
        world.friction = friction;
        const auto scene = make_solid(folding_arms(), world);
        scene->set_target(1, -1.5);
        run_ticks(*scene, 240);
        CAPTURE(friction, angle, scene->joint_coordinate(1), scene->audit().evaluations);
        CHECK(std::fabs(scene->joint_coordinate(1) + angle) < 4e-4);
        CHECK(std::fabs(scene->joint_rate(1)) < 1e-6);
        CHECK(scene->part_twist(0).angular.norm() < 1e-9);
        CHECK(scene->center_of_mass_velocity().norm() < 1e-12);
        CHECK(scene->face_touched(1, Face::kDistal));
        CHECK(scene->face_touched(2, Face::kLeft));
        CHECK(scene->audit().max_penetration < 2e-3);
        // Without friction the force follows from the torque.
        if (friction == 0.0) CHECK(total_force(*scene) == Approx(kStrength / lever).epsilon(1e-3));
        std::vector<SceneContact> contacts;
        scene->list_contacts(contacts);
        REQUIRE(contacts.size() == 2);
        const double z = std::fabs(contacts[0].point.z());
        CHECK(z == Approx(0.06).margin(1e-6));
        const Vec3 face = scene->part_pose(2).orientation * Vec3::UnitY();
        CHECK(contacts[0].normal.dot(face) == Approx(1.0).margin(1e-9));
    }
}

TEST_CASE("Without contact between parts an arm in space passes through the other") {
    const auto scene = make_solid(folding_arms(), weightless());
    scene->set_target(1, -1.5);
    run_ticks(*scene, 120);
    CHECK(scene->joint_coordinate(1) == Approx(-1.5).margin(1e-3));
    CHECK(!scene->face_touched(2, Face::kLeft));
    // It may be turned on at any time.
    const auto touched = make_solid(folding_arms(), weightless());
    touched->set_environment(touching(weightless()));
    touched->set_target(1, -1.5);
    run_ticks(*touched, 120);
    CHECK(touched->face_touched(2, Face::kLeft));
}

TEST_CASE("Boxes in space that slide together part as their elasticity has it") {
    for (const double elasticity : {0.0, 0.5, 1.0}) {
        constexpr double speed = 1.5;
        Environment world = touching(weightless());
        world.elasticity = elasticity;
        const auto scene = make_solid(sliding_boxes(), world);
        SceneMotion motion = scene->motion();
        motion.speeds[0] = speed;
        motion.speeds[1] = -speed;
        REQUIRE(scene->begin_at(motion));
        const double before = scene->energy();
        double impulse = 0.0;
        double lost = 0.0;
        std::vector<SceneImpact> impacts;
        for (int tick = 0; tick < 12; ++tick) {
            run_ticks(*scene, 1);
            scene->list_impacts(impacts);
            for (const SceneImpact& impact : impacts) {
                CHECK(impact.part + impact.other_part == 3);
                CHECK((impact.point - Vec3(scene->center_of_mass().x(), 0.2, 0.0)).norm() < 0.1);
                impulse += impact.impulse;
                lost += impact.lost;
            }
        }
        const double mass = 8.0;  // kg, of each
        // Without bounce they are pushed to the distance of rest.
        const double allowed = elasticity > 0.0 ? 1e-3 : 4e-3;
        CAPTURE(elasticity, scene->joint_rate(1), scene->joint_rate(2));
        CHECK(scene->joint_rate(1) == Approx(-elasticity * speed).margin(allowed));
        CHECK(scene->joint_rate(2) == Approx(elasticity * speed).margin(allowed));
        CHECK(impulse == Approx(mass * speed * (1.0 + elasticity)).epsilon(1e-3));
        CHECK(lost == Approx(mass * speed * speed * (1.0 - elasticity * elasticity)).margin(0.02));
        CHECK(scene->energy() <= before * (1.0 + 1e-12));
        CHECK(std::fabs(scene->audit().energy_residual) < 1e-9 * before);
    }
}

TEST_CASE("Touching itself in space neither moves nor turns a creature, nor gives it energy") {
    int touches = 0;
    double most_turned = 0.0;
    double most_gain = 0.0;
    double most_residual = 0.0;
    double most_work = 0.0;
    double deepest = 0.0;
    for (std::uint64_t creature = 0; creature < 24; ++creature) {
        RandomStream random(stream_seed({122, creature}));
        Environment world = touching(weightless());
        world.elasticity = 0.5 * static_cast<double>(creature % 3);
        world.friction = 0.4 * static_cast<double>(creature / 3 % 4);
        const bool limp = creature % 2 == 0;
        const int parts = random.between(5, 16);
        const BodyPlan plan = random_solid(random, parts, limp ? 0.0 : 25000.0);
        SceneSettings fine;
        fine.tolerance = 1e-4;
        const auto scene = make_solid(plan, world, fine);
        if (limp) throw_limp(*scene, random);
        const Vec3 momentum = angular_momentum(*scene, world.density);
        const double start = scene->energy();
        const double weight = scene->mass() * kEarthGravity;
        double before = start;
        for (int tick = 0; tick < 300; ++tick) {
            if (!limp) swing(*scene, plan);
            run_ticks(*scene, 1);
            if (limp) most_gain = std::fmax(most_gain, (scene->energy() - before) / weight);
            before = scene->energy();
            for (std::size_t p = 0; p < plan.parts.size(); ++p) {
                for (std::size_t face = 0; face < kFaceCount; ++face)
                    touches += scene->face_touched(p, static_cast<Face>(face)) ? 1 : 0;
            }
        }
        const Vec3 turned = angular_momentum(*scene, world.density) - momentum;
        most_turned = std::fmax(most_turned, turned.norm() / scene->mass());
        CHECK(scene->center_of_mass_velocity().norm() < 1e-12);
        const SceneAudit& audit = scene->audit();
        const double scale = limp ? start : audit.gross_motor_work;
        most_residual = std::fmax(most_residual, std::fabs(audit.energy_residual) / scale);
        most_work = std::fmax(most_work, audit.positive_work / scale);
        deepest = std::fmax(deepest, audit.max_penetration);
    }
    const std::string figures = fmt::format(
        "{} touches; turned by {:.1e} m^2/s; gain in a tick {:.1e} m of weight, residual {:.1e} "
        "and "
        "positive work {:.1e} of the energy; {:.2f} mm deep",
        touches, most_turned, most_gain, most_residual, most_work, 1e3 * deepest);
    INFO(figures);
    CHECK(touches > 1000);
    CHECK(most_turned < 1e-12);
    CHECK(most_gain < 1e-3);
    CHECK(most_residual < 0.02);
    CHECK(most_work < 0.02);
    CHECK(deepest < 0.01);
}

TEST_CASE("A saved state in space whose parts touch goes on with the same bits") {
    const auto scene = make_solid(folding_arms(), touching(weightless()));
    scene->set_target(1, -1.5);
    run_ticks(*scene, 30);
    const auto saved = scene->save();
    const auto digest = [&] {
        run_ticks(*scene, 60);
        Hash64 hash;
        scene->add_to_digest(hash);
        return hash.value();
    };
    const std::uint64_t first = digest();
    REQUIRE(scene->face_touched(2, Face::kLeft));
    scene->restore(*saved);
    CHECK(digest() == first);
}

}  // namespace cambrian
