// Boxes that are fast enough to be on the other side of each other at the end of a step.
#include "planar/bodies.h"
#include "planar/constraints/contact_solver.h"
#include "planar/model_building.h"
#include "planar/planar_scene.h"
#include "support/catch.h"

#include <array>
#include <cmath>
#include <vector>

using namespace cambrian;

namespace {

// Runs differ in where the step's ends lie, and in angles.
struct Run {
    double phase = 0.0;  // share of a step
    double turn = 0.0;   // rad
};

std::vector<Run> runs_of(int count, std::uint64_t seed) {
    RandomStream random(stream_seed({seed}));
    std::vector<Run> runs;
    for (int i = 0; i < count; ++i)
        runs.push_back({(i + 0.5) / count, i % 3 == 0 ? 0.0 : random.uniform(-0.5, 0.5)});
    return runs;
}

// Adds the first part of another plan as a tree of its own.
void add_tree(BodyPlan& plan, const BodyPlan& other) {
    plan.parts.push_back(other.parts[0]);
}

void give_speeds(PhysicsScene& scene, const std::vector<Vec3>& velocities, double spin = 0.0) {
    SceneMotion motion = scene.motion();
    const std::size_t bodies = motion.speeds.size() - 2 * velocities.size();
    motion.speeds[0] = spin;
    for (std::size_t tree = 0; tree < velocities.size(); ++tree) {
        motion.speeds[bodies + 2 * tree] = velocities[tree].x();
        motion.speeds[bodies + 2 * tree + 1] = velocities[tree].y();
    }
    REQUIRE(scene.begin_at(motion));
}

// Lets two upright plates of this thickness (m) meet, one of which stands still. Returns whether
// one got to the other side.
bool passes_plate(double thickness, double speed, const Run& run, double elasticity) {
    Environment space = empty_space();
    space.elasticity = elasticity;
    const double distance = 0.3 + speed * kTestTick * run.phase;
    BodyPlan plan = one_box(0.2, 0.5 * thickness, 0.0, 0.0, 0.5 * kPi);
    add_tree(plan, one_box(0.2, 0.5 * thickness, distance, 0.0, 0.5 * kPi + run.turn));
    const auto scene = make_scene(plan, space);
    give_speeds(*scene, {Vec3(speed, 0.0, 0.0), Vec3::Zero()});
    const int ticks = static_cast<int>(std::ceil(0.5 / (speed * kTestTick)));
    bool passed = false;
    for (int tick = 0; tick < ticks; ++tick) {
        REQUIRE(cambrian::run(*scene, kTestTick));
        passed = passed || scene->part_center(0).x() > scene->part_center(1).x();
    }
    CHECK(scene->audit().max_penetration < 0.01);
    return passed;
}

// Lets a box of 10 cm meet a fixed one of this thickness (m). Returns whether it got to the other
// side.
bool passes_wall(double thickness, double speed, const Run& run) {
    const double half = 0.5 * thickness;
    const Vec3 along(-std::sin(run.turn), std::cos(run.turn), 0.0);
    const Vec3 normal(along.y(), -along.x(), 0.0);
    const std::vector<FixedBox> walls = {box_around(-1.0 * along, 1.0 * along, half)};
    const double distance = 0.4 + speed * kTestTick * run.phase;
    const auto scene =
        make_scene(one_box(0.05, 0.05, -distance, 0.0, 2.0 * run.turn), empty_space());
    scene->set_fixed_boxes(walls);
    give_speeds(*scene, {Vec3(speed, 0.0, 0.0)}, 4.0 * run.turn);
    const int ticks = static_cast<int>(std::ceil(0.6 / (speed * kTestTick)));
    bool passed = false;
    for (int tick = 0; tick < ticks; ++tick) {
        REQUIRE(cambrian::run(*scene, kTestTick));
        passed = passed || scene->center_of_mass().dot(normal) > 0.0;
    }
    CHECK(scene->audit().max_penetration < 0.01);
    return passed;
}

// Returns the place of a point in the frame of a part.
Vec3 seen_from(const PhysicsScene& scene, std::size_t part, const Vec3& point) {
    const Vec3 axis = scene.part_axis(part);
    const Vec3 apart = point - scene.part_center(part);
    return {apart.dot(axis), apart.y() * axis.x() - apart.x() * axis.y(), 0.0};
}

}  // namespace

TEST_CASE("plates stop each other at any speed", "[dynamics][swept]") {
    for (const double thickness : {0.02, 0.08}) {
        for (const double speed : {3.0, 10.0, 20.0, 30.0, 60.0, 400.0}) {
            int passed = 0;
            for (const Run& run : runs_of(48, 91))
                passed += passes_plate(thickness, speed, run, 0.2) ? 1 : 0;
            CAPTURE(thickness, speed);
            CHECK(passed == 0);
        }
    }
}

TEST_CASE("a fixed box stops a fast one at any speed", "[dynamics][swept][fixed_box]") {
    for (const double speed : {8.0, 15.0, 30.0, 400.0}) {
        int passed = 0;
        for (const Run& run : runs_of(24, 92))
            passed += passes_wall(0.04, speed, run) ? 1 : 0;
        CAPTURE(speed);
        CHECK(passed == 0);
    }
}

TEST_CASE("a spinning rod does not turn through a fixed pin or a free one",
          "[dynamics][swept][fixed_box]") {
    for (const bool is_fixed : {true, false}) {
        for (int start = 0; start < 24; ++start) {
            const double angle = -0.3 - 0.05 * start;
            BodyPlan plan = one_box(0.5, 0.02, 0.0, 0.0, angle);
            if (!is_fixed) add_tree(plan, one_box(0.02, 0.02, 0.4, 0.0));
            const auto scene = make_scene(plan, empty_space());
            const std::vector<FixedBox> pins = {
                box_around({0.399, 0.0, 0.0}, {0.401, 0.0, 0.0}, 0.02)};
            if (is_fixed) scene->set_fixed_boxes(pins);
            give_speeds(*scene, std::vector<Vec3>(is_fixed ? 1 : 2, Vec3::Zero()), 60.0);
            double turned = 0.0;
            for (int tick = 0; tick < 6; ++tick) {
                REQUIRE(run(*scene, kTestTick));
                const Vec3 pin = is_fixed ? pins[0].center : scene->part_center(1);
                const Vec3 seen = seen_from(*scene, 0, pin);
                turned = scene->part_twist(0).angular.z();
                CAPTURE(is_fixed, angle, tick);
                if (seen.norm() < 0.45) CHECK(seen.y() > 0.0);
            }
            CHECK(turned < 59.0);
            CHECK(scene->audit().max_penetration < 0.02);
        }
    }
}

// The impacts of one tick are many more than those that may bounce.
TEST_CASE("a fast plate does not pass a row of thin ones", "[dynamics][swept][joined]") {
    for (const double elasticity : {0.0, 1.0}) {
        for (int phase = 0; phase < 8; ++phase) {
            Environment space = empty_space();
            space.elasticity = elasticity;
            const SceneKind kind = planar_scene_kind();
            std::vector<std::unique_ptr<PhysicsScene>> scenes;
            std::vector<PhysicsScene*> members;
            for (int i = 0; i < 16; ++i) {
                const double x = i == 0 ? -0.3 - 0.06 * phase : 0.03 * i;
                scenes.push_back(make_scene(one_box(0.15, 0.01, x, 0.0, 0.5 * kPi), space));
                members.push_back(scenes.back().get());
            }
            give_speeds(*members[0], {Vec3(30.0, 0.0, 0.0)});
            const auto workspace = scenes[0]->take_workspace();
            const auto joined = kind.join(members);
            for (int tick = 0; tick < 12; ++tick) {
                REQUIRE(joined->advance(members, kTestTick, *workspace) == SceneStatus::kRunning);
                for (std::size_t i = 1; i < members.size(); ++i) {
                    CAPTURE(elasticity, phase, tick, i);
                    CHECK(members[i]->center_of_mass().x() > members[i - 1]->center_of_mass().x());
                }
            }
            CHECK(members[0]->audit().max_penetration < 0.01);
            CHECK(members.back()->center_of_mass_velocity().x() > 1.0);
        }
    }
}

// Turning together is no motion past each other, and neither is falling.
TEST_CASE("boxes that move together are not looked at within a step", "[dynamics][swept]") {
    BodyPlan plan = one_box(0.2, 0.02, 0.0, 0.0);
    attach(plan, 0, Vec3(0.2, 0.0, 0.0), 0.5 * kPi, kRotaryJoint, 0.1, 0.02);
    attach(plan, 1, Vec3(0.1, 0.0, 0.0), 0.3 * kPi, kRotaryJoint, 0.1, 0.02);
    const PlanarModel model = *build_planar_model(plan, 1.0);
    ContactSolver contacts;
    contacts.forget_model();
    Motion motion = rest_motion(model);
    const auto looks = [&](double angle, double bend, double x) {
        Kinematics ends[2];
        for (Kinematics& end : ends) {
            compute_kinematics(model, motion, end);
            contacts.detect(model, {}, end);
            for (int body = 0; body < model.body_count; ++body)
                motion.position[body] += angle;
            motion.position[model.body_count - 1] += bend;
            motion.position[center_of(model, 0)] += x;
        }
        return contacts.count_looks(model, {}, ends[0], ends[1]);
    };
    REQUIRE(model.colliding_pairs.size() == 1);
    CHECK(looks(0.0, 0.0, 0.0) == 1);
    CHECK(looks(0.5, 0.0, 3.0) == 1);
    CHECK(looks(0.5, 1.0, 3.0) > 2);
}
