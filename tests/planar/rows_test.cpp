#include "planar/constraints/rows.h"

#include "planar/bodies.h"
#include "planar/model_building.h"
#include "planar/random_motion.h"
#include "support/catch.h"

#include <cmath>

using namespace cambrian;

namespace {

// Contacts at one corner of every body on the ground, and every stop.
struct Sources {
    ContactSet contacts;
    LimitSet limits;
};

Sources touching_everywhere(RandomStream& random, const PlanarModel& model, const Kinematics& k) {
    Sources sources;
    for (int body = 0; body < model.body_count; ++body) {
        Contact contact;
        contact.id = 4 * body;
        contact.body_a = body;
        contact.part_a = body;
        contact.arm_ax = 0.1 * random.gauss();
        contact.arm_ay = 0.1 * random.gauss();
        contact.point_x = k.cosine[body] * contact.arm_ax + k.sine[body] * contact.arm_ay;
        contact.point_y = k.cosine[body] * contact.arm_ay - k.sine[body] * contact.arm_ax;
        contact.closing_speed = -(k.velocity_y[body] + k.spin[body] * contact.arm_ax);
        sources.contacts.add(contact);
        if (model.parent[body] >= 0) sources.limits.add({body, body % 2 == 0 ? 1.0 : -1.0, 0.0});
    }
    return sources;
}

struct Evaluated {
    EvaluationCache cache = {};
    MotionRate rate = {};
};

Evaluated random_evaluated(RandomStream& random, const PlanarModel& model) {
    const Motion motion = random_motion(random, model);
    Evaluated state;
    evaluate_accelerations(model, {}, motion, {0.0, EvaluationDetail::kEverything}, state.cache,
                           state.rate);
    complete_cache(model, state.cache);
    return state;
}

}  // namespace

TEST_CASE("rows are coupled as impulses move the bodies", "[dynamics][rows]") {
    RandomStream random(stream_seed({81}));
    for (int round = 0; round < 40; ++round) {
        const double linear_share = round % 2 == 0 ? 0.0 : 0.5;
        const auto model = build_planar_model(
            random_tree(random, random.between(2, 20), linear_share, 20.0, 0.0), 1.0);
        REQUIRE(model);
        const Evaluated state = random_evaluated(random, *model);
        const Sources sources = touching_everywhere(random, *model, state.cache.kinematics);
        static ConstraintSystem rows;
        build_rows(*model, {sources.contacts, sources.limits, true, 1e-2}, state.cache.kinematics,
                   state.cache, rows);
        REQUIRE(rows.count == 3 * model->body_count - 1);
        for (int column = 0; column < rows.count; ++column) {
            double unit[kMaxRows] = {};
            unit[column] = 1.0;
            Loads loads;
            BodyResponse jumps[2] = {};
            double rates[2][kMaxRows];
            clear_loads(*model, loads);
            add_row_impulses(rows, unit, 1.0, loads);
            solve_impulse(*model, state.cache.kinematics, state.cache.factors, loads, jumps[0]);
            rate_rows(*model, rows, jumps, rates);
            INFO("round " << round << ", column " << column);
            for (int row = 0; row < rows.count; ++row) {
                const double softness = row == column ? rows[row].regularization : 0.0;
                CHECK(rows.coupling(row, column) - softness ==
                      Approx(rates[0][row]).epsilon(1e-9).margin(1e-9));
            }
        }
    }
}

TEST_CASE("all contacts of a body with the ground share one friction row, at the nearest",
          "[dynamics][rows]") {
    RandomStream random(stream_seed({82}));
    const auto model = build_planar_model(random_tree(random, 3, 0.0, 20.0, 0.0), 1.0);
    REQUIRE(model);
    const Evaluated state = random_evaluated(random, *model);
    ContactSet contacts;
    for (int c = 0; c < 5; ++c) {
        Contact contact;
        contact.body_a = c % 2;
        contact.gap = c == 3 ? -1e-3 : 0.0;
        contact.arm_ax = 0.01 * c;
        contacts.add(contact);
    }
    static ConstraintSystem rows;
    build_rows(*model, {contacts, {}, true, 1e-2}, state.cache.kinematics, state.cache, rows);
    REQUIRE(rows.count == 7);
    int normals = 0;
    for (int row = 0; row < rows.count; ++row) {
        if (rows[row].kind == RowKind::kFriction) continue;
        ++normals;
        const Row& friction = rows[rows[row].friction_of];
        CHECK(friction.kind == RowKind::kFriction);
        CHECK(friction.body_a == rows[row].body_a);
        CHECK(friction.source == (rows[row].body_a == 0 ? 0 : 3));
    }
    CHECK(normals == 5);
}

TEST_CASE("a full set of contacts drops the farthest and keeps its order", "[dynamics][rows]") {
    ContactSet contacts;
    for (int c = 0; c < kContactsOfOne + 2; ++c) {
        Contact contact;
        contact.id = c;
        contact.gap = c == 5 || c == 7 ? 1e-2 : -1e-3;
        contacts.add(contact);
    }
    REQUIRE(contacts.count == kContactsOfOne);
    for (int c = 1; c < contacts.count; ++c)
        CHECK(contacts.items[c - 1].id < contacts.items[c].id);
    for (int c = 0; c < contacts.count; ++c)
        CHECK(contacts.items[c].gap == -1e-3);
    Contact farther;
    CHECK(contacts.make_room(farther.gap) == nullptr);
}
