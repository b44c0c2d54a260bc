#include "planar/model/dense_form.h"

#include "planar/bodies.h"
#include "planar/constraints/rows.h"
#include "planar/evaluation/accelerations.h"
#include "planar/model_building.h"
#include "planar/random_motion.h"
#include "support/catch.h"

#include <cmath>

using namespace cambrian;

namespace {

struct Evaluation {
    EvaluationCache cache = {};
    MotionRate rate = {};
};

Evaluation evaluated(const PlanarModel& model, const Forcing& forcing, const Motion& motion) {
    Evaluation evaluation;
    evaluate_accelerations(model, forcing, motion, {0.3, EvaluationDetail::kEverything},
                           evaluation.cache, evaluation.rate);
    complete_cache(model, evaluation.cache);
    return evaluation;
}

// Returns the largest difference of the values, relative to the largest value.
double difference(const double* first, const double* second, int count) {
    double scale = 1.0;
    double widest = 0.0;
    for (int i = 0; i < count; ++i) {
        scale = std::fmax(scale, std::fabs(second[i]));
        widest = std::fmax(widest, std::fabs(first[i] - second[i]));
    }
    return widest / scale;
}

// Returns a creature of at most kMaxDenseBodies bodies; with `welds`, every fourth box has a fixed
// joint.
PlanarModel creature(RandomStream& random, bool welds) {
    BodyPlan plan = random_tree(random, random.between(1, kMaxDenseBodies), 0.0, 20.0, 0.0);
    for (std::size_t part = 3; welds && part < plan.parts.size(); part += 4)
        plan.parts[part].motion = kRigidJoint;
    const auto model = build_planar_model(plan, 1.3);
    REQUIRE(model);
    return *model;
}

Forcing random_forcing(RandomStream& random, const PlanarModel& model) {
    Forcing forcing;
    forcing.medium = {1.0, -9.81, 0.5, 2.0};
    if (random.chance(0.5)) forcing.medium = {0.0, -9.81, 0.0, 0.0};
    forcing.drive.frequency = 25.0;
    forcing.drive.speed_limit = 6.0;
    for (int i = 1; i < model.body_count; ++i) {
        forcing.drive.start[i] = random.gauss();
        forcing.drive.end[i] = random.gauss();
    }
    return forcing;
}

// A creature in the middle of a step with implicit motors, in dense and in recursive form.
struct ImplicitStages {
    ImplicitStages(RandomStream& random, bool welds)
        : model(creature(random, welds)), tree_model(model), motion(random_motion(random, model)) {
        const Forcing forcing = random_forcing(random, model);
        tree_model.dense.blocks = 0;
        PerBody start_rate = {};
        for (int i = 1; i < model.body_count; ++i)
            start_rate[i] = 3.0 * random.gauss();
        const ImplicitStage stage{1.0 / 120, start_rate};
        const EvaluationPoint point{0.3, EvaluationDetail::kEverything, &stage};
        evaluate_accelerations(model, forcing, motion, point, dense.cache, dense.rate);
        evaluate_accelerations(tree_model, forcing, motion, point, tree.cache, tree.rate);
        find_centers(model, dense.cache);
    }

    PlanarModel model, tree_model;
    Motion motion;
    Evaluation dense, tree;
};

// Returns contacts at two points of every body on the ground, contacts between some pairs, and all
// stops.
ContactSet scattered_contacts(RandomStream& random, const PlanarModel& model) {
    ContactSet contacts;
    for (int i = 0; i < 2 * model.body_count; ++i) {
        Contact contact;
        contact.id = i;
        contact.body_a = i % model.body_count;
        contact.part_a = contact.body_a;
        if (i % 3 == 1 && contact.body_a > 0) {
            contact.body_b = 0;
            contact.part_b = 0;
            contact.id = kGroundContactIds + i * kIdsPerPair;
        }
        const double turn = random.gauss();
        contact.normal_x = sine(turn);
        contact.normal_y = cosine(turn);
        contact.arm_ax = 0.1 * random.gauss();
        contact.arm_ay = 0.1 * random.gauss();
        contact.arm_bx = 0.1 * random.gauss();
        contact.arm_by = 0.1 * random.gauss();
        contacts.add(contact);
    }
    return contacts;
}

}  // namespace

TEST_CASE("the dense form gives what the tree form gives", "[dynamics][dense]") {
    RandomStream random(stream_seed({61}));
    for (int round = 0; round < 400; ++round) {
        INFO(round);
        const PlanarModel model = creature(random, round % 2 == 1);
        const Motion motion = random_motion(random, model);
        const Forcing forcing = random_forcing(random, model);
        REQUIRE(is_dense(model, forcing));
        PlanarModel tree_model = model;
        tree_model.dense.blocks = 0;
        const Evaluation dense = evaluated(model, forcing, motion);
        const Evaluation tree = evaluated(tree_model, forcing, motion);
        const int bodies = model.body_count;
        const int coordinates = coordinate_count(model);
        constexpr double kClose = 1e-12;
        CHECK(difference(dense.rate.acceleration, tree.rate.acceleration, coordinates) < kClose);
        CHECK(difference(dense.rate.power, tree.rate.power, kWorkCount) < kClose);
        CHECK(difference(dense.cache.response.coordinate, tree.cache.response.coordinate,
                         coordinates) < kClose);
        const auto same = [&](const PerBody& first, const PerBody& second) {
            return difference(first, second, bodies) < kClose;
        };
        CHECK(same(dense.cache.response.x, tree.cache.response.x));
        CHECK(same(dense.cache.response.y, tree.cache.response.y));
        CHECK(same(dense.cache.response.spin, tree.cache.response.spin));
        CHECK(same(dense.cache.motor_effort, tree.cache.motor_effort));
        const Kinematics& k = dense.cache.kinematics;
        const Kinematics& expected = tree.cache.kinematics;
        CHECK(same(k.x, expected.x));
        CHECK(same(k.y, expected.y));
        CHECK(same(k.velocity_x, expected.velocity_x));
        CHECK(same(k.velocity_y, expected.velocity_y));
        CHECK(same(k.z_x, expected.z_x));
        CHECK(same(k.gamma_y, expected.gamma_y));
        CHECK(same(k.joint_position, expected.joint_position));
        CHECK(same(dense.cache.factors.w_x, tree.cache.factors.w_x));
        CHECK(same(dense.cache.factors.inverse_d, tree.cache.factors.inverse_d));
    }
}

TEST_CASE("the dense form answers impulses with implicit motors as the tree form does",
          "[dynamics][dense]") {
    RandomStream random(stream_seed({63}));
    for (int round = 0; round < 200; ++round) {
        INFO(round);
        const ImplicitStages stages(random, round % 2 == 1);
        const PlanarModel& model = stages.model;
        const Evaluation& dense = stages.dense;
        const Evaluation& tree = stages.tree;
        REQUIRE(dense.cache.is_inverted);
        const int bodies = model.body_count;
        const int coordinates = coordinate_count(model);
        constexpr double kClose = 1e-11;
        CHECK(difference(dense.rate.acceleration, tree.rate.acceleration, coordinates) < kClose);
        CHECK(difference(dense.rate.power, tree.rate.power, kWorkCount) < kClose);
        CHECK(difference(dense.cache.motor_damping, tree.cache.motor_damping, bodies) < kClose);
        CHECK(difference(dense.cache.response.x, tree.cache.response.x, bodies) < kClose);
        CHECK(difference(dense.cache.response.spin, tree.cache.response.spin, bodies) < kClose);

        Loads loads = {};
        for (int i = 0; i < bodies; ++i) {
            loads.force_x[i] = random.gauss();
            loads.force_y[i] = random.gauss();
            loads.torque[i] = 0.1 * random.gauss();
            if (i > 0) loads.effort[i] = 0.1 * random.gauss();
        }
        PerCoordinate jump = {};
        solve_dense_impulse(model, dense.cache, loads, jump);
        BodyResponse expected;
        solve_impulse(stages.tree_model, tree.cache.kinematics, tree.cache.factors, loads,
                      expected);
        CHECK(difference(jump, expected.coordinate, coordinates) < kClose);
        BodyResponse spread;
        spread_dense_rates(model, dense.cache.kinematics, jump, spread.spin, spread.x, spread.y);
        CHECK(difference(spread.x, expected.x, bodies) < kClose);
        CHECK(difference(spread.y, expected.y, bodies) < kClose);
        CHECK(difference(spread.spin, expected.spin, bodies) < kClose);
        PerCoordinate turned = {};
        Loads efforts = {};
        for (int i = 1; i < bodies; ++i)
            efforts.effort[i] = loads.effort[i];
        solve_dense_efforts(model, dense.cache, efforts.effort, turned);
        solve_impulse(stages.tree_model, tree.cache.kinematics, tree.cache.factors, efforts,
                      expected);
        CHECK(difference(turned, expected.coordinate, coordinates) < kClose);
    }
}

TEST_CASE("the dense form couples rows as the tree form does", "[dynamics][dense]") {
    RandomStream random(stream_seed({64}));
    for (int round = 0; round < 100; ++round) {
        INFO(round);
        const ImplicitStages stages(random, round % 2 == 1);
        const PlanarModel& model = stages.model;
        const Evaluation& dense = stages.dense;
        const Evaluation& tree = stages.tree;
        const ContactSet contacts = scattered_contacts(random, model);
        LimitSet limits;
        for (int i = 1; i < model.body_count; ++i)
            limits.add({i, i % 2 == 0 ? 1.0 : -1.0, 0.0});
        const RowSources sources{contacts, limits, true, 1e-2};
        static ConstraintSystem rows;
        static ConstraintSystem expected;
        build_rows(model, sources, dense.cache.kinematics, dense.cache, rows);
        build_rows(stages.tree_model, sources, tree.cache.kinematics, tree.cache, expected);
        REQUIRE(rows.count == expected.count);
        for (int row = 0; row < rows.count; ++row) {
            const double acceleration = expected[row].acceleration;
            CHECK(rows[row].acceleration == Approx(acceleration).epsilon(1e-11).margin(1e-11));
            CHECK(difference(rows.line(row), expected.line(row), rows.stride) < 1e-10);
        }
    }
}

TEST_CASE("the dense form is left where it does not apply", "[dynamics][dense]") {
    RandomStream random(stream_seed({62}));
    const auto large =
        build_planar_model(random_tree(random, kMaxDenseBodies + 1, 0.0, 1.0, 0.0), 1.0);
    CHECK_FALSE(is_dense(*large, {}));
    const auto sliding = build_planar_model(random_tree(random, 4, 1.0, 1.0, 0.0), 1.0);
    CHECK_FALSE(is_dense(*sliding, {}));
    const auto small = build_planar_model(chain(3, 1.0), 1.0);
    Forcing forcing;
    CHECK(is_dense(*small, forcing));
    const HeldForces held;
    forcing.held = &held;
    CHECK_FALSE(is_dense(*small, forcing));
}
