// Several scenes that are advanced as one, with contacts between their bodies.
#include "planar/bodies.h"
#include "planar/planar_scene.h"
#include "support/catch.h"

#include <cmath>

using namespace cambrian;

namespace {

Environment on_ground(double elasticity = 0.2) {
    Environment environment;
    environment.elasticity = elasticity;
    return environment;
}

// Scenes that are advanced as one.
class Group {
public:
    Group(const std::vector<BodyPlan>& plans, const Environment& environment) {
        for (const BodyPlan& plan : plans) {
            auto scene = kind_.make(plan, environment, {});
            REQUIRE(scene);
            scenes_.push_back(std::move(*scene));
            members_.push_back(scenes_.back().get());
        }
        workspace_ = scenes_.front()->take_workspace();
        joined_ = kind_.join(members_);
    }

    PhysicsScene& operator[](std::size_t index) { return *scenes_[index]; }
    std::size_t size() const { return scenes_.size(); }
    bool run(double time) {
        for (int tick = 0; tick < std::lround(time / kTestTick); ++tick) {
            if (joined_->advance(members_, kTestTick, *workspace_) != SceneStatus::kRunning)
                return false;
        }
        return true;
    }
    double fastest() const {
        double speed = 0.0;
        for (const auto& scene : scenes_) {
            for (std::size_t part = 0; part < scene->part_count(); ++part)
                speed = std::max(speed, scene->part_twist(part).linear.norm());
        }
        return speed;
    }
    double deepest() const {
        double depth = 0.0;
        for (const auto& scene : scenes_)
            depth = std::max(depth, scene->audit().max_penetration);
        return depth;
    }
    Vec3 momentum() const {
        Vec3 sum = Vec3::Zero();
        for (const auto& scene : scenes_)
            sum += scene->mass() * scene->center_of_mass_velocity();
        return sum;
    }

private:
    SceneKind kind_ = planar_scene_kind();
    std::vector<std::unique_ptr<PhysicsScene>> scenes_;
    std::vector<PhysicsScene*> members_;
    std::unique_ptr<SceneWorkspace> workspace_;
    std::unique_ptr<JoinedScenes> joined_;
};

void push(PhysicsScene& scene, const Vec3& velocity) {
    SceneMotion motion = scene.motion();
    motion.speeds[motion.speeds.size() - 2] = velocity.x();
    motion.speeds[motion.speeds.size() - 1] = velocity.y();
    REQUIRE(scene.begin_at(motion));
}

// Angular momentum of a scene of one box about the origin.
double angular_momentum(const PhysicsScene& box) {
    const Vec3 half = box.part_half_extents(0);
    const double inertia = box.mass() * (half.x() * half.x() + half.y() * half.y()) / 3.0;
    return box.mass() * box.center_of_mass().cross(box.center_of_mass_velocity()).z() +
           inertia * box.part_twist(0).angular.z();
}

// A floor with two walls.
BodyPlan pit(double half_width, double height) {
    BodyPlan plan = one_box(half_width + 0.4, 0.1, 0.0, 0.1);
    for (const double side : {-1.0, 1.0}) {
        PlannedPart wall =
            one_box(0.2, height / 2, side * (half_width + 0.2), 0.2 + height / 2).parts[0];
        wall.parent = 0;
        wall.motion = JointMotion::kFixed;
        wall.anchor_in_parent = Vec3(side * (half_width + 0.2), 0.1, 0.0);
        wall.anchor_in_child = Vec3(0.0, -height / 2, 0.0);
        plan.parts.push_back(wall);
    }
    return plan;
}

}  // namespace

TEST_CASE("a stack of three creatures comes to rest", "[dynamics][joined]") {
    Group stack({one_box(0.3, 0.2, 0.0, 0.25), one_box(0.25, 0.15, 0.02, 0.65),
                 one_box(0.2, 0.1, -0.03, 0.95)},
                on_ground());
    REQUIRE(stack.run(2.0));
    CHECK(stack.fastest() <= 1e-4);
    CHECK(stack.deepest() < 0.01);
    CHECK(stack[1].center_of_mass().y() == Approx(0.55).margin(2e-3));
    CHECK(stack[2].center_of_mass().y() == Approx(0.8).margin(2e-3));
    CHECK(stack[1].face_touched(0, Face::kLeft));
    CHECK(stack[1].face_touched(0, Face::kRight));
}

TEST_CASE("sixteen boxes in a pit come to rest", "[dynamics][joined]") {
    std::vector<BodyPlan> plans = {pit(0.9, 2.5)};
    for (int i = 0; i < 16; ++i) {
        const double x = 0.45 * (i % 4 - 1.5) + 0.01 * (i / 4);
        plans.push_back(
            one_box(0.2 - 0.01 * (i % 3), 0.15 + 0.01 * (i % 2), x, 0.5 + 0.45 * (i / 4)));
    }
    Group boxes(plans, on_ground());
    REQUIRE(boxes.run(10.0));
    CHECK(boxes.fastest() <= 1e-3);
    CHECK(boxes.deepest() <= 0.02);
    for (std::size_t i = 1; i < boxes.size(); ++i) {
        CHECK(std::fabs(boxes[i].center_of_mass().x() - boxes[0].part_center(0).x()) < 0.9);
        CHECK(boxes[i].center_of_mass().y() > 0.3);
    }
}

TEST_CASE("a collision keeps momentum and angular momentum", "[dynamics][joined]") {
    Environment space = empty_space();
    space.elasticity = 0.5;
    space.friction = 0.6;
    Group pair({one_box(0.3, 0.1, 0.0, 0.0), one_box(0.2, 0.2, 0.9, 0.12, 0.3)}, space);
    push(pair[1], Vec3(-2.0, 0.3, 0.0));
    const Vec3 before = pair.momentum();
    const double turning = angular_momentum(pair[0]) + angular_momentum(pair[1]);
    REQUIRE(pair.run(1.0));
    CHECK(pair[0].center_of_mass_velocity().norm() > 0.5);
    CHECK((pair.momentum() - before).norm() < 1e-12 * before.norm());
    CHECK(angular_momentum(pair[0]) + angular_momentum(pair[1]) == Approx(turning).epsilon(1e-9));
    CHECK(pair.deepest() < 5e-3);
}

TEST_CASE("impacts of two scenes say what energy they took, and whose they are",
          "[dynamics][joined]") {
    Environment space = empty_space();
    space.elasticity = 0.3;
    space.friction = 0.6;
    Group pair({one_box(0.3, 0.1, 0.0, 0.0), one_box(0.2, 0.2, 0.9, 0.12, 0.3)}, space);
    push(pair[1], Vec3(-2.0, 0.3, 0.0));
    const double before = pair[1].kinetic_energy();
    double lost = 0.0;
    for (int tick = 0; tick < 60; ++tick) {
        REQUIRE(pair.run(kTestTick));
        std::vector<SceneImpact> of_first;
        std::vector<SceneImpact> of_second;
        pair[0].list_impacts(of_first);
        pair[1].list_impacts(of_second);
        REQUIRE(of_first.size() == of_second.size());
        for (std::size_t i = 0; i < of_first.size(); ++i) {
            CHECK(of_first[i].other_scene == &pair[1]);
            CHECK(of_second[i].other_scene == &pair[0]);
            CHECK(of_first[i].lost == of_second[i].lost);
            CHECK(of_first[i].lost > 0.0);
            lost += of_first[i].lost;
        }
    }
    const double after = pair[0].kinetic_energy() + pair[1].kinetic_energy();
    CHECK(lost > 0.1 * before);
    CHECK(lost == Approx(before - after).epsilon(0.01));
}

TEST_CASE("creatures far apart that are advanced as one move as if alone", "[dynamics][joined]") {
    RandomStream random(7);
    const std::vector<BodyPlan> plans = {random_tree(random, 5, 0.3, 10.0, 0.0),
                                         random_tree(random, 6, 0.0, 10.0, 0.0)};
    Group group(plans, open_water());
    std::vector<std::unique_ptr<PhysicsScene>> alone;
    for (std::size_t i = 0; i < plans.size(); ++i) {
        alone.push_back(make_scene(plans[i], open_water()));
        const Vec3 place(20.0 * static_cast<double>(i), 0.0, 0.0);
        group[i].translate(place);
        alone[i]->translate(place);
    }
    for (int tick = 0; tick < 60; ++tick) {
        for (std::size_t i = 0; i < plans.size(); ++i) {
            flail(group[i], plans[i], 1.0);
            flail(*alone[i], plans[i], 1.0);
            REQUIRE(run(*alone[i], kTestTick));
        }
        REQUIRE(group.run(kTestTick));
    }
    for (std::size_t i = 0; i < plans.size(); ++i) {
        for (std::size_t part = 0; part < plans[i].parts.size(); ++part)
            CHECK((group[i].part_center(part) - alone[i]->part_center(part)).norm() < 0.02);
        const SceneAudit& audit = alone[i]->audit();
        CHECK(audit.gross_motor_work > 0.5);
        CHECK(group[i].audit().gross_motor_work == Approx(audit.gross_motor_work).epsilon(0.02));
        CHECK(std::fabs(group[i].audit().energy_residual) < 0.02 * audit.energy_scale);
    }
}

TEST_CASE("joined creatures keep their spin while they do not touch", "[dynamics][joined]") {
    std::vector<BodyPlan> plans;
    for (int i = 0; i < 3; ++i) {
        plans.push_back(chain(3 + i, 1.0, 5.0 * i));
        for (PlannedPart& part : plans.back().parts)
            part.max_effort = 2.0;
    }
    Group group(plans, empty_space());
    double spin[3] = {};
    double gross[3] = {};
    for (int tick = 0; tick < 300; ++tick) {
        for (std::size_t i = 0; i < group.size(); ++i)
            flail(group[i], plans[i], 2.0);
        REQUIRE(group.run(kTestTick));
        for (std::size_t i = 0; i < group.size(); ++i) {
            const AngularMomentum momentum = angular_momentum_of(group[i], empty_space().density);
            spin[i] = std::max(spin[i], std::fabs(momentum.sum));
            gross[i] = std::max(gross[i], momentum.gross);
        }
    }
    for (int i = 0; i < 3; ++i) {
        CHECK(gross[i] > 1e-3);
        CHECK(spin[i] < 1e-9 * gross[i]);
    }
}

TEST_CASE("a scene goes back to the moment it marked", "[dynamics][joined]") {
    const BodyPlan plan = chain(3, 1.0, 0.0, 0.3);
    const auto scene = make_scene(plan, on_ground());
    REQUIRE(run(*scene, 0.5));
    scene->pull(1, Vec3::Zero(), Vec3(1.0, 3.0, 0.0));
    scene->pull(2, Vec3::Zero(), Vec3(0.0, 2.0, 0.0));
    scene->mark();
    const auto twin = make_scene(plan, on_ground());
    twin->restore(*scene->save());
    twin->pull(1, Vec3::Zero(), Vec3(1.0, 3.0, 0.0));
    twin->pull(2, Vec3::Zero(), Vec3(0.0, 2.0, 0.0));
    for (int round = 0; round < 3; ++round) {
        REQUIRE(run(*scene, kTestTick));
        if (round == 0) REQUIRE(run(*twin, kTestTick));
        CHECK(scene->motion().positions == twin->motion().positions);
        CHECK(scene->audit().energy_residual == twin->audit().energy_residual);
        scene->go_back();
    }
}
