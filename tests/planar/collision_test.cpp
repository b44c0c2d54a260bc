#include "planar/rig.h"
#include "support/catch.h"

#include <cmath>
#include <vector>

using namespace cambrian;

namespace {

constexpr double kHalf = 0.1;  // m

// Returns the heights of a box's first apexes above its resting place when dropped flat from 1 m.
std::vector<double> apexes(double restitution, std::size_t count, SceneAudit* audit = nullptr) {
    Environment environment;
    environment.elasticity = restitution;
    const auto scene = make_scene(one_box(0.2, kHalf, 0.0, 1.0 + kHalf), environment);
    std::vector<double> heights;
    double highest = 0.0;
    bool rising = false;
    for (int tick = 0; tick < 60 * 30 && heights.size() < count; ++tick) {
        if (scene->advance(1.0 / 480) != SceneStatus::kRunning) break;
        const double speed = scene->center_of_mass_velocity().y();
        // The height of the next apex follows from the present position and speed.
        const double apex = scene->center_of_mass().y() - kHalf + speed * speed / (2 * 9.81);
        if (rising && speed < 0.0) heights.push_back(highest);
        if (speed > 0.0) highest = apex;
        rising = speed > 0.0;
    }
    if (audit != nullptr) *audit = scene->audit();
    return heights;
}

struct PointSpeeds {
    double normal, tangential;  // m/s
};

PointSpeeds speeds_at(const Contact& contact, const Kinematics& k) {
    const int a = contact.body_a;
    return {k.velocity_y[a] + k.spin[a] * contact.arm_ax,
            k.velocity_x[a] - k.spin[a] * contact.arm_ay};
}

}  // namespace

TEST_CASE("a corner that sticks stops exactly and bounces exactly", "[dynamics][collision]") {
    Environment environment;
    environment.friction = 100.0;
    environment.elasticity = 0.3;
    int struck = 0;
    for (int round = 0; round < 60; ++round) {
        RandomStream random(stream_seed({static_cast<std::uint64_t>(round), 74}));
        Rig rig(random_tree(random, 1 + round % 12, 0.0, 0.0, 5.0), environment);
        Motion& motion = rig.state.motion;
        motion.position[0] += random.uniform(-3.0, 3.0);
        Kinematics& k = rig.state.cache().kinematics;
        compute_kinematics(rig.model, motion, k);
        double lowest = 100.0;
        for (int corner = 0; corner < 4 * rig.model.part_count; ++corner) {
            const int b = rig.model.part_body[corner / 4];
            lowest = std::fmin(lowest, k.y[b] + k.sine[b] * rig.model.corner_x[corner] +
                                           k.cosine[b] * rig.model.corner_y[corner]);
        }
        motion.position[center_of(rig.model, 0) + 1] += kRestingGap - lowest;
        for (int c = 0; c < rig.model.body_count; ++c)
            motion.speed[c] = random.uniform(-3.0, 3.0);
        motion.speed[center_of(rig.model, 0)] = random.uniform(-3.0, 3.0);
        motion.speed[center_of(rig.model, 0) + 1] = -10.0;
        rig.begin();
        complete_cache(rig.model, rig.state.cache());
        ContactSolver contacts;
        contacts.detect(rig.model, rig.law, k);
        if (!contacts.has_impact()) continue;
        contacts.solve_impact(rig.model, rig.law, environment.elasticity, rig.state.cache(),
                              motion);
        // Contacts of a larger group support each other.
        if (contacts.selected().count != 1) continue;
        const Contact& corner = contacts.selected().items[0];
        const PointSpeeds before = speeds_at(corner, k);
        compute_kinematics(rig.model, motion, k);
        const PointSpeeds after = speeds_at(corner, k);
        const double scale = std::hypot(before.normal, before.tangential);
        INFO("round " << round);
        CHECK(std::fabs(after.tangential) <= 1e-3 * scale);
        CHECK(std::fabs(after.normal + 0.3 * before.normal) <= 1e-3 * scale);
        ++struck;
    }
    CHECK(struck > 30);
}

TEST_CASE("no corner of a fast spinner gets through the ground", "[dynamics][collision]") {
    for (int round = 0; round < 200; ++round) {
        RandomStream random(stream_seed({static_cast<std::uint64_t>(round), 75}));
        Rig rig(one_box(0.35, 0.05, 0.0, random.uniform(0.2, 0.36)), {});
        rig.state.motion.speed[0] = random.uniform(20.0, 120.0);
        rig.begin();
        REQUIRE(rig.run(0.5));
        INFO("round " << round);
        CHECK(rig.state.audit.max_penetration <= 2e-3);
    }
}

TEST_CASE("a box bounces to its height times the coefficient of restitution squared",
          "[dynamics][collision]") {
    for (const double e : {0.5, 0.8, 1.0}) {
        const std::vector<double> heights = apexes(e, 2);
        REQUIRE(heights.size() == 2);
        CHECK(std::fabs(heights[0] - e * e) <= kContactBand);
        CHECK(std::fabs(heights[1] - e * e * e * e) <= kContactBand);
    }
}

TEST_CASE("a box without restitution does not bounce", "[dynamics][collision]") {
    Environment environment;
    environment.elasticity = 0.0;
    const auto scene = make_scene(one_box(0.2, kHalf, 0.0, 1.0 + kHalf), environment);
    REQUIRE(run(*scene, 1.0));
    CHECK(std::fabs(scene->center_of_mass().y() - kHalf) <= kContactBand);
    CHECK(scene->center_of_mass_velocity().norm() < 1e-3);
}

TEST_CASE("a perfectly elastic bounce does no work", "[dynamics][collision]") {
    SceneAudit audit;
    REQUIRE(apexes(1.0, 3, &audit).size() == 3);
    CHECK(audit.events >= 3);
    CHECK(std::fabs(audit.impulse_work) <= 1e-3 * 0.08 * 9.81);
    CHECK(std::fabs(audit.energy_residual) < 1e-6);
}

TEST_CASE("an inelastic landing takes all energy of the fall", "[dynamics][collision]") {
    Environment environment;
    environment.elasticity = 0.0;
    const auto scene = make_scene(one_box(0.2, kHalf, 0.0, 1.0 + kHalf), environment);
    REQUIRE(run(*scene, 2.0));
    CHECK(scene->audit().impulse_work == Approx(-scene->mass() * 9.81).epsilon(2e-3));
    CHECK(std::fabs(scene->audit().energy_residual) < 1e-6);
}

TEST_CASE("a sliding box stops where friction says", "[dynamics][collision]") {
    Environment environment;
    environment.friction = 0.5;
    Rig rig(one_box(0.2, kHalf, 0.0, kHalf + kRestingGap), environment);
    rig.state.motion.speed[center_of(rig.model, 0)] = 3.0;
    rig.begin();
    REQUIRE(rig.run(2.0));
    CHECK(rig.state.motion.position[center_of(rig.model, 0)] ==
          Approx(9.0 / (2 * 0.5 * 9.81)).epsilon(2e-4));
    CHECK(std::fabs(rig.state.motion.position[0]) < 1e-6);
    CHECK(rig.state.audit.contact_work == Approx(-0.5 * 0.08 * 9.0).epsilon(2e-4));
}

TEST_CASE("a box on a slope creeps below the friction angle and slides above it",
          "[dynamics][collision]") {
    for (const double share : {0.5, 0.9, 1.1, 1.5}) {
        const double slope = share * 0.5;  // tan alpha
        const double cosine = 1.0 / std::sqrt(1.0 + slope * slope);
        Environment environment;
        environment.friction = 0.5;
        environment.gravity_direction = -90.0 + arc_tangent(slope) * 180.0 / kPi;
        Rig rig(one_box(0.3, kHalf, 0.0, kHalf + kRestingGap), environment);
        rig.begin();
        REQUIRE(rig.run(1.0));
        const double start = rig.state.motion.position[center_of(rig.model, 0)];
        const double speed = rig.state.motion.speed[center_of(rig.model, 0)];
        REQUIRE(rig.run(4.0));
        if (share < 1.0) {
            CHECK(std::fabs(rig.state.motion.position[center_of(rig.model, 0)] - start) < 1e-5);
        } else {
            const double expected = 9.81 * cosine * (slope - 0.5);
            CHECK((rig.state.motion.speed[center_of(rig.model, 0)] - speed) / 4.0 ==
                  Approx(expected).epsilon(1e-4));
        }
    }
}

TEST_CASE("a box dropped on its edge comes to rest and stays there", "[dynamics][collision]") {
    for (const double angle : {0.1, 0.5, 0.78}) {
        Environment environment;
        environment.elasticity = 0.3;
        const auto scene = make_scene(one_box(0.2, kHalf, 0.0, 1.0, angle), environment);
        REQUIRE(run(*scene, 5.0));
        const Vec3 place = scene->center_of_mass();
        const SceneAudit fallen = scene->audit();
        CHECK(fallen.events <= 50);
        double fastest = 0.0;
        double creep = 0.0;
        for (int tick = 0; tick < 5 * 60; ++tick) {
            REQUIRE(run(*scene, kTestTick));
            fastest = std::fmax(fastest, scene->center_of_mass_velocity().norm());
            creep = std::fmax(creep, (scene->center_of_mass() - place).norm());
        }
        CHECK(fastest <= 1e-4);
        CHECK(creep <= 1e-5);
        CHECK(scene->audit().events == fallen.events);
        CHECK(scene->audit().evaluations - fallen.evaluations <= 5 * 400);
        CHECK(scene->audit().evaluations <= 10 * 400);
    }
}

TEST_CASE("a chain with motors off dropped on the ground settles", "[dynamics][collision]") {
    Environment environment;
    environment.elasticity = 0.3;
    Rig rig(chain(6, 1.0, 0.0, 1.5), environment);
    rig.begin();
    REQUIRE(rig.run(20.0));
    const double fallen = rig.model.total_mass * 9.81 * 1.5;
    CHECK(rig.speed() < 1e-4);
    CHECK(std::fabs(rig.state.audit.energy_residual) < 1e-3 * fallen);
    CHECK(rig.state.audit.positive_work < 1e-3 * fallen);
}

TEST_CASE("three boxes on top of each other come to rest", "[dynamics][collision]") {
    BodyPlan plan = one_box(0.2, 0.1, 0.0, 0.11);
    for (int level = 1; level < 3; ++level) {
        PlannedPart box = plan.parts[0];
        box.rest_pose = planar_pose(0.03 * level, 0.11 + 0.215 * level, 0.0);
        plan.parts.push_back(box);
    }
    Rig rig(plan, {});
    REQUIRE(rig.model.tree_count == 3);
    rig.begin();
    REQUIRE(rig.run(2.0));
    for (int tick = 0; tick < 60; ++tick) {
        REQUIRE(rig.run(kTestTick));
        CHECK(rig.speed() < 1e-4);
    }
    for (int level = 0; level < 3; ++level) {
        const int center = center_of(rig.model, level);
        CHECK(rig.state.motion.position[center] == Approx(0.03 * level).margin(1e-3));
        CHECK(rig.state.motion.position[center + 1] ==
              Approx(0.1 + 0.2 * level + (level + 1) * kRestingGap).margin(1e-4));
    }
}
