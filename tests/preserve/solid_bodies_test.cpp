#include "preserve/bodies/solid_bodies.h"

#include "core/random.h"
#include "preserve/world/fastest_point.h"
#include "support/body_plans.h"
#include "support/build_speed.h"
#include "support/catch.h"
#include "support/kinds.h"

#include <cmath>

namespace cambrian {
namespace {

using namespace test;

Environment bouncy_space() {
    Environment space = empty_space();
    space.elasticity = 0.5;
    return space;
}

class Bodies {
public:
    explicit Bodies(std::size_t workers = 1, Environment environment = bouncy_space(),
                    std::vector<FixedBox> walls = {}, const Torus& torus = {})
        : environment_(std::move(environment)),
          walls_(std::move(walls)),
          torus_(torus),
          solid_(creature_kinds().scene, torus),
          pool_(workers) {}
    explicit Bodies(const Torus& torus, std::size_t workers = 1)
        : Bodies(workers, bouncy_space(), {}, torus) {}

    PhysicsScene& add(const BodyPlan& plan, const Vec3& velocity) {
        auto scene = creature_kinds().scene.make(plan, environment_, {});
        REQUIRE(scene);
        (*scene)->set_fixed_boxes(walls_);
        SceneMotion motion = (*scene)->motion();
        motion.speeds[motion.speeds.size() - 2] = velocity.x();
        motion.speeds[motion.speeds.size() - 1] = velocity.y();
        REQUIRE((*scene)->begin_at(motion));
        auto workspace = (*scene)->take_workspace();
        if (workspaces_.size() < pool_.workers()) workspaces_.push_back(std::move(workspace));
        bodies_.push_back({.number = bodies_.size() + 1, .scene = scene->get()});
        scenes_.push_back(std::move(*scene));
        return *scenes_.back();
    }
    void tick() {
        for (SolidBody& body : bodies_) {
            body.bounds = body.scene->bounds();
            body.fastest = fastest_point(*body.scene);
        }
        const auto nothing = [](std::size_t) {};
        solid_.advance(bodies_, kTestTick, {nothing, nothing}, workspaces_, pool_);
    }

    // Returns the pairs of bodies, or images of them, that overlap and were neither joined there
    // nor crowded.
    int missed() const {
        const std::vector<SweptBounds> extents = all_extents();
        int missed = 0;
        for (std::uint32_t a = 0; a < scenes_.size(); ++a) {
            for (std::uint32_t b = a + 1; b < scenes_.size(); ++b) {
                if (are_crowded(a, b)) continue;
                const bool joined = solid_.were_joined(a, b);
                for (const Periods& image : images_beside(a, b)) {
                    if (joined && image == Periods{}) continue;
                    SweptBounds there = extents[b];
                    move(there, torus_.shift_of(image));
                    missed += meet(extents[a], there) ? 1 : 0;
                }
            }
        }
        return missed;
    }
    Vec3 momentum() const {
        Vec3 sum = Vec3::Zero();
        for (const auto& scene : scenes_)
            sum += scene->mass() * scene->center_of_mass_velocity();
        return sum;
    }
    double kinetic_energy() const {
        double sum = 0.0;
        for (const auto& scene : scenes_)
            sum += scene->kinetic_energy();
        return sum;
    }
    // Returns how far the two bodies that overlap most overlap (m).
    double deepest_overlap() const {
        const std::vector<SweptBounds> extents = all_extents();
        double depth = 0.0;
        for (std::size_t a = 0; a < extents.size(); ++a) {
            for (std::size_t b = a + 1; b < extents.size(); ++b)
                depth = std::max(depth, -gap_between(extents[a], extents[b], 0.0));
        }
        return depth;
    }
    double deepest() const {
        double depth = 0.0;
        for (const auto& scene : scenes_)
            depth = std::max(depth, scene->audit().max_penetration);
        return depth;
    }
    std::uint64_t digest() const {
        Hash64 digest;
        for (const auto& scene : scenes_)
            scene->add_to_digest(digest);
        return digest.value();
    }
    PhysicsScene& operator[](std::size_t index) { return *scenes_[index]; }
    SceneStatus status(std::size_t index) const { return bodies_[index].status; }
    const SolidCounts& counts() const { return solid_.counts(); }
    std::size_t size() const { return scenes_.size(); }

private:
    std::vector<SweptBounds> all_extents() const {
        std::vector<SweptBounds> extents(scenes_.size());
        for (std::size_t i = 0; i < scenes_.size(); ++i)
            find_parts(*scenes_[i], extents[i]);
        return extents;
    }
    // Returns the images of the second body that are nearest to the first one.
    std::vector<Periods> images_beside(std::uint32_t a, std::uint32_t b) const {
        if (!torus_.meets()) return std::vector<Periods>(1);
        const Periods nearest = Periods{} - torus_.image_of(scenes_[b]->center_of_mass() -
                                                            scenes_[a]->center_of_mass());
        const std::int32_t across = torus_.width > 0.0 ? 1 : 0;
        const std::int32_t upwards = torus_.height > 0.0 ? 1 : 0;
        std::vector<Periods> images;
        for (std::int32_t x = -across; x <= across; ++x) {
            for (std::int32_t y = -upwards; y <= upwards; ++y)
                images.push_back(nearest + Periods{x, y});
        }
        return images;
    }
    static bool meet(const SweptBounds& a, const SweptBounds& b) {
        for (const Rectangle& first : a.parts) {
            for (const Rectangle& second : b.parts) {
                if (overlap(first, second)) return true;
            }
        }
        return false;
    }
    bool are_crowded(std::uint32_t a, std::uint32_t b) const {
        return std::any_of(
            solid_.crowded().begin(), solid_.crowded().end(),
            [&](const NearPair& pair) { return pair.first == a && pair.second == b; });
    }

    Environment environment_;
    std::vector<FixedBox> walls_;
    Torus torus_;
    SolidBodies solid_;
    ThreadPool pool_;
    std::vector<std::unique_ptr<PhysicsScene>> scenes_;
    std::vector<std::unique_ptr<SceneWorkspace>> workspaces_;
    std::vector<SolidBody> bodies_;
};

// Boxes and chains of three that fly about in a square of 2 * side.
void scatter(Bodies& bodies, int count, double side, double speed, std::uint64_t seed) {
    RandomStream random(stream_seed({seed, static_cast<std::uint64_t>(Purpose::kTest)}));
    for (int i = 0; i < count; ++i) {
        const double x = random.uniform(-side, side);
        const double y = random.uniform(-side, side);
        const Vec3 velocity(random.uniform(-speed, speed), random.uniform(-speed, speed), 0.0);
        bodies.add(i % 3 == 0 ? chain(3, 1.0, x, y)
                              : one_box(random.uniform(0.1, 0.3), 0.1, x, y, random.uniform(0, 3)),
                   velocity);
    }
}

TEST_CASE("no two bodies meet that the broad phase did not expect", "[preserve][solid]") {
    std::uint64_t joined = 0;
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        Bodies bodies;
        scatter(bodies, 40, 5.0, 3.0, seed);
        for (int tick = 0; tick < 120; ++tick) {
            bodies.tick();
            REQUIRE(bodies.missed() == 0);
        }
        joined += bodies.counts().joined_ticks;
    }
    CHECK(joined > 1000);
}

TEST_CASE("no two bodies meet across edges that the broad phase did not expect",
          "[preserve][solid][edges]") {
    constexpr std::uint64_t seeds = by_build<std::uint64_t>(4, 1);
    for (const double size : {5.0, 10.0, 11.3}) {
        std::uint64_t joined = 0;
        for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
            Bodies bodies(Torus{size, size});
            scatter(bodies, static_cast<int>(4.0 * size), 0.5 * size, 3.0, seed);
            for (int tick = 0; tick < 120; ++tick) {
                bodies.tick();
                REQUIRE(bodies.missed() == 0);
            }
            joined += bodies.counts().joined_ticks;
            for (std::size_t i = 0; i < bodies.size(); ++i)
                CHECK(bodies.status(i) == SceneStatus::kRunning);
        }
        CHECK(joined > 125 * seeds);
    }
}

TEST_CASE("two bodies that meet across an edge bounce off, and keep their momentum",
          "[preserve][solid][edges]") {
    // A light one from the right, and a heavy one several widths away.
    Bodies bodies(Torus{10.0, 0.0});
    bodies.add(one_box(0.2, 0.1, 4.5, 0.0), Vec3(1.0, 0.1, 0.0));
    bodies.add(one_box(0.2, 0.2, 35.5, 0.02), Vec3::Zero());
    bodies.add(one_box(0.2, 0.2, -4.5, 2.0), Vec3::Zero());
    const Vec3 before = bodies.momentum();
    const double energy = bodies.kinetic_energy();
    for (int tick = 0; tick < 90; ++tick) {
        bodies.tick();
        REQUIRE(bodies.missed() == 0);
    }
    CHECK((bodies.momentum() - before).norm() < 1e-12 * before.norm());
    CHECK(bodies.kinetic_energy() < energy);
    CHECK(bodies[1].center_of_mass_velocity().x() > 0.3);
    CHECK(bodies[0].center_of_mass_velocity().x() < bodies[1].center_of_mass_velocity().x());
    CHECK(bodies.counts().joined_ticks > 0);
    CHECK(bodies.deepest() < 0.01);
    // The second one was moved to beside the first one, and the third one met nobody.
    CHECK(std::fabs(bodies[1].center_of_mass().x() - bodies[0].center_of_mass().x()) < 3.0);
    CHECK(bodies[2].center_of_mass() == Vec3(-4.5, 2.0, 0.0));
}

TEST_CASE("a ring of bodies around the world is crowded at one place, and keeps its momentum",
          "[preserve][solid][edges]") {
    Bodies bodies(Torus{5.0, 5.0});
    for (int i = 0; i < 12; ++i)
        bodies.add(one_box(0.2, 0.2, -2.5 + i * 5.0 / 12.0, 0.001 * (i % 3)),
                   Vec3(i % 2 == 0 ? 0.3 : -0.2, 0.0, 0.0));
    const Vec3 before = bodies.momentum();
    for (int tick = 0; tick < 240; ++tick) {
        bodies.tick();
        REQUIRE(bodies.missed() == 0);
    }
    CHECK((bodies.momentum() - before).norm() < 1e-11);
    CHECK(bodies.counts().joined_ticks > 1000);
    for (std::size_t i = 0; i < bodies.size(); ++i)
        CHECK(bodies.status(i) == SceneStatus::kRunning);
}

TEST_CASE("a hundred crowded boxes stay bounded and keep their momentum", "[preserve][solid]") {
    Bodies bodies;
    for (int i = 0; i < 100; ++i) {
        const Vec3 place(0.36 * (i % 10 - 4.5), 0.36 * (i / 10 - 4.5), 0.0);
        bodies.add(one_box(0.15, 0.15, place.x(), place.y()),
                   -0.6 * place + Vec3(0.02 * (i % 7), 0.3, 0.0));
    }
    const Vec3 before = bodies.momentum();
    const double energy = bodies.kinetic_energy();
    for (int tick = 0; tick < 180; ++tick)
        bodies.tick();
    CHECK((bodies.momentum() - before).norm() < 1e-12 * before.norm());
    CHECK(bodies.counts().crowded_ticks > 100);
    CHECK(bodies.deepest() < 0.1);
    CHECK(bodies.kinetic_energy() < energy);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        CHECK(bodies.status(i) == SceneStatus::kRunning);
        CHECK(bodies[i].center_of_mass().norm() < 10.0);
    }
}

TEST_CASE("a hundred boxes dropped into a pit stay in it, and apart", "[preserve][solid]") {
    constexpr double kHalfWidth = 1.6;
    std::vector<FixedBox> walls;
    for (const double side : {-1.0, 1.0}) {
        const double x = side * (kHalfWidth + 0.2);
        walls.push_back(box_around({x, 0.0, 0.0}, {x, 8.0, 0.0}, 0.2));
    }
    Bodies boxes(1, Environment{}, std::move(walls));
    RandomStream random(stream_seed({5, static_cast<std::uint64_t>(Purpose::kTest)}));
    for (int i = 0; i < 100; ++i) {
        const double x = 0.46 * (i % 6 - 2.5) + random.uniform(-0.02, 0.02);
        const double angle = random.uniform(0.0, 1.5);
        boxes.add(one_box(0.16 - 0.01 * (i % 3), 0.15, x, 0.3 + 0.46 * (i / 6), angle),
                  Vec3::Zero());
    }
    double deepest = 0.0;
    for (int tick = 0; tick < 90; ++tick) {
        boxes.tick();
        deepest = std::max(deepest, boxes.deepest_overlap());
    }
    CHECK(deepest <= 0.1);
    CHECK(boxes.counts().crowded_ticks > 1000);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        CHECK(boxes.status(i) == SceneStatus::kRunning);
        CHECK(std::fabs(boxes[i].center_of_mass().x()) < kHalfWidth);
        CHECK(boxes[i].bounds().low.y() > -0.02);
    }
}

// A floor of 4.8 m with a wall at each end, as one body.
BodyPlan floating_pit() {
    BodyPlan pit = one_box(2.4, 0.5, 0.0, -0.5);
    for (const double side : {-1.0, 1.0}) {
        PlannedPart wall = one_box(0.3, 2.0, side * 2.1, 2.0).parts[0];
        wall.parent = 0;
        wall.motion = kRigidJoint;
        wall.anchor_in_parent = Vec3(side * 2.1, 0.5, 0.0);
        wall.anchor_in_child = Vec3(0.0, -2.0, 0.0);
        pit.parts.push_back(wall);
    }
    return pit;
}

TEST_CASE("a hundred boxes thrown into a floating pit keep the momentum of all",
          "[preserve][solid]") {
    Bodies bodies(1, empty_space());
    const PhysicsScene& pit = bodies.add(floating_pit(), Vec3(0.0, 0.5, 0.0));
    for (int i = 0; i < 100; ++i) {
        const double x = 0.34 * (i % 10 - 4.5) + 0.02 * (i / 10 % 3 - 1);
        bodies.add(one_box(0.16 - 0.01 * (i % 3), 0.15, x, 0.3 + 0.36 * (i / 10)),
                   Vec3(0.02 * (i % 7), -2.0, 0.0));
    }
    const Vec3 before = bodies.momentum();
    double deepest = 0.0;
    for (int tick = 0; tick < 120; ++tick) {
        bodies.tick();
        deepest = std::max(deepest, bodies.deepest_overlap());
    }
    CHECK((bodies.momentum() - before).norm() < 1e-12 * before.norm());
    CHECK(deepest <= 0.1);
    CHECK(bodies.counts().crowded_ticks > 100);
    for (std::size_t i = 1; i < bodies.size(); ++i) {
        const Vec3 place = bodies[i].center_of_mass() - pit.part_center(0);
        CHECK(bodies.status(i) == SceneStatus::kRunning);
        CHECK(std::fabs(place.x()) < 1.8);
        CHECK(place.y() > 0.5);
        CHECK(place.y() < 5.0);
    }
}

TEST_CASE("a body that gets farther than expected is advanced again with whom it meets",
          "[preserve][solid]") {
    Bodies bodies;
    PhysicsScene& thrown = bodies.add(one_box(0.1, 0.1, 0.0, 0.0), Vec3::Zero());
    PhysicsScene& hit = bodies.add(one_box(0.1, 0.1, 0.32, 0.0), Vec3::Zero());
    bodies.add(one_box(0.1, 0.1, 5.0, 0.0), Vec3::Zero());
    bodies.tick();
    CHECK(bodies.counts().joined_ticks == 0);
    // Gains 9 m/s in a tick, and so gets 0.15 m far at least.
    thrown.pull(0, Vec3::Zero(), Vec3(thrown.mass() * 9.0 / kTestTick, 0.0, 0.0));
    bodies.tick();
    CHECK(bodies.counts().redone == 1);
    CHECK(bodies.counts().joined_ticks == 2);
    CHECK(bodies.missed() == 0);
    for (int tick = 0; tick < 5; ++tick)
        bodies.tick();
    CHECK(hit.center_of_mass_velocity().x() > 4.0);
    CHECK(bodies.deepest() < 0.01);
    CHECK(bodies.momentum().x() == Approx(thrown.mass() * 9.0).epsilon(1e-9));
}

TEST_CASE("bodies that meet nobody move as if alone, bit by bit", "[preserve][solid]") {
    Bodies bodies(2);
    std::vector<std::unique_ptr<PhysicsScene>> alone;
    for (int i = 0; i < 6; ++i) {
        const BodyPlan plan = chain(3 + i % 3, 1.0, 6.0 * (i % 3), 6.0 * (i / 3));
        bodies.add(plan, Vec3(0.1 * i, 0.0, 0.0));
        alone.push_back(std::move(*creature_kinds().scene.make(plan, empty_space(), {})));
        REQUIRE(alone.back()->begin_at(bodies[static_cast<std::size_t>(i)].motion()));
    }
    for (int tick = 0; tick < 120; ++tick) {
        for (std::size_t i = 0; i < alone.size(); ++i) {
            const double target = tick % 40 < 20 ? 0.6 : -0.6;
            bodies[i].set_target(1, target);
            alone[i]->set_target(1, target);
            REQUIRE(run(*alone[i], kTestTick));
        }
        bodies.tick();
    }
    for (std::size_t i = 0; i < alone.size(); ++i) {
        CHECK(bodies[i].motion().positions == alone[i]->motion().positions);
        CHECK(bodies[i].motion().speeds == alone[i]->motion().speeds);
    }
}

TEST_CASE("a body whose motion fails is left out, and its neighbours go on", "[preserve][solid]") {
    Bodies bodies;
    bodies.add(one_box(0.2, 0.1, 0.0, 0.0), Vec3(0.5, 0.0, 0.0));
    bodies.add(one_box(0.2, 0.1, 0.45, 0.0), Vec3::Zero());
    PhysicsScene& broken = bodies.add(one_box(0.2, 0.1, 0.9, 0.0), Vec3::Zero());
    bodies.tick();
    CHECK(bodies.counts().joined_ticks > 0);
    // More than the fastest motion that counts as valid.
    broken.pull(0, Vec3::Zero(), Vec3(broken.mass() * 2e4 / kTestTick, 0.0, 0.0));
    bodies.tick();
    CHECK(bodies.status(2) != SceneStatus::kRunning);
    CHECK(bodies.status(0) == SceneStatus::kRunning);
    CHECK(bodies.status(1) == SceneStatus::kRunning);
    CHECK(bodies[0].center_of_mass().x() == Approx(2 * 0.5 * kTestTick).epsilon(1e-6));
}

TEST_CASE("workers do not change the bits of colliding bodies", "[preserve][solid][threads]") {
    const Torus torus = GENERATE(Torus{}, Torus{8.0, 8.0});
    std::vector<std::uint64_t> digests;
    for (const std::size_t workers : {1U, 2U, 7U}) {
        Bodies bodies(torus, workers);
        scatter(bodies, 60, 4.0, 2.0, 9);
        for (int tick = 0; tick < 90; ++tick)
            bodies.tick();
        CHECK(bodies.counts().joined_ticks > 500);
        digests.push_back(bodies.digest());
    }
    CHECK(digests[1] == digests[0]);
    CHECK(digests[2] == digests[0]);
}

}  // namespace
}  // namespace cambrian
