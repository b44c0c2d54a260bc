#include "planar/contact/box_contacts.h"
#include "planar/contact/self_contacts.h"
#include "planar/island/joined_model.h"
#include "planar/random_motion.h"
#include "planar/rig.h"
#include "support/build_speed.h"
#include "support/catch.h"

#include <cmath>
#include <limits>

using namespace cambrian;

namespace {

PlacedBox random_box(RandomStream& random) {
    const SineCosine turn = sine_cosine(random.uniform(-kPi, kPi));
    return {random.uniform(-0.4, 0.4), random.uniform(-0.4, 0.4), turn.cosine, turn.sine,
            random.uniform(0.05, 0.4), random.uniform(0.05, 0.4)};
}

// Returns the depth of a point in a box; negative outside.
double depth_in(const PlacedBox& box, double x, double y) {
    const double along = box.axis_x * (x - box.x) + box.axis_y * (y - box.y);
    const double across = box.axis_x * (y - box.y) - box.axis_y * (x - box.x);
    return std::fmin(box.half_length - std::fabs(along), box.half_width - std::fabs(across));
}

// Returns a bar with two arms that a motor claps together above it.
BodyPlan clapper() {
    BodyPlan plan = one_box(0.3, 0.05, 0.0, 0.0);
    for (const double side : {-1.0, 1.0}) {
        PlannedPart& arm =
            attach(plan, 0, Vec3(0.3 * side, 0.05, 0.0), kPi / 2, kRotaryJoint, 0.25, 0.04);
        arm.limit_low = -1.4;
        arm.limit_high = 1.4;
        arm.max_effort = 0.5;
    }
    return plan;
}

}  // namespace

TEST_CASE("contact points of boxes lie on the incident box, as deep as they say",
          "[dynamics][self_contact]") {
    RandomStream random(stream_seed({51}));
    int touching = 0;
    for (int round = 0; round < 5000; ++round) {
        const PlacedBox first = random_box(random);
        const PlacedBox second = random_box(random);
        const BoxManifold manifold = collide_boxes(first, second, 0.0);
        touching += manifold.count > 0 ? 1 : 0;
        const PlacedBox& incident = manifold.first_is_incident ? first : second;
        const PlacedBox& reference = manifold.first_is_incident ? second : first;
        for (int i = 0; i < manifold.count; ++i) {
            CHECK(depth_in(incident, manifold.x[i], manifold.y[i]) == Approx(0.0).margin(1e-12));
            CHECK(manifold.gap[i] <= 0.0);
            const double surface_x = manifold.x[i] - manifold.gap[i] * manifold.normal_x;
            const double surface_y = manifold.y[i] - manifold.gap[i] * manifold.normal_y;
            CHECK(depth_in(reference, surface_x, surface_y) == Approx(0.0).margin(1e-12));
        }
    }
    CHECK(touching > 1000);
}

TEST_CASE("boxes touch exactly when one holds a corner of the other or they cross",
          "[dynamics][self_contact]") {
    RandomStream random(stream_seed({52}));
    for (int round = 0; round < 5000; ++round) {
        const PlacedBox first = random_box(random);
        const PlacedBox second = random_box(random);
        bool holds = false;
        for (int corner = 0; corner < 4; ++corner) {
            const double sx = (corner & 1) != 0 ? 1.0 : -1.0;
            const double sy = (corner & 2) != 0 ? 1.0 : -1.0;
            const auto corner_in = [&](const PlacedBox& a, const PlacedBox& b) {
                return depth_in(
                           b, a.x + sx * a.half_length * a.axis_x - sy * a.half_width * a.axis_y,
                           a.y + sx * a.half_length * a.axis_y + sy * a.half_width * a.axis_x) >
                       1e-9;
            };
            holds = holds || corner_in(first, second) || corner_in(second, first);
        }
        if (holds) CHECK(collide_boxes(first, second, 1e-3).count > 0);
    }
}

TEST_CASE("arms that clap touch and do not pass through each other", "[dynamics][self_contact]") {
    const BodyPlan plan = clapper();
    const auto scene = make_scene(plan, empty_space());
    scene->set_target(1, -1.4);
    scene->set_target(2, 1.4);
    bool touched = false;
    for (int tick = 0; tick < 240; ++tick) {
        REQUIRE(scene->advance(kTestTick) == SceneStatus::kRunning);
        touched = touched ||
                  (scene->face_touched(1, Face::kDistal) || scene->face_touched(1, Face::kRight));
    }
    CHECK(touched);
    CHECK(scene->audit().max_penetration < 0.01);
    CHECK(scene->joint_coordinate(1) > -1.3);
}

// The integrator's error turns the creature, in proportion to the tolerance to the power of 2/3: by
// up to 1.5e-4 kg m^2/s at 1e-6 and 3.5e-5 at 1e-7.
TEST_CASE("touching itself does not move or turn a creature in empty space",
          "[dynamics][self_contact]") {
    constexpr std::uint64_t seeds = test::by_build(10, 3);
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
        RandomStream random(stream_seed({seed, 53}));
        const BodyPlan plan = random_tree(random, 10, 0.2, 30.0, 0.0);
        Rig rig(plan, empty_space(), "bogacki-shampine", 1e-7);
        rig.begin();
        for (int tick = 0; tick < 300; ++tick) {
            for (int i = 1; i < rig.model.body_count; ++i) {
                rig.forcing.drive.start[i] = rig.forcing.drive.end[i];
                rig.forcing.drive.end[i] = sine(0.05 * tick * i + i);
            }
            REQUIRE(rig.run(kTestTick));
        }
        CHECK(rig.state.audit.gross_motor_work > 0.1);
        CHECK(std::fabs(rig.state.motion.speed[center_of(rig.model, 0)]) < 1e-10);
        CHECK(std::fabs(rig.state.motion.speed[center_of(rig.model, 0) + 1]) < 1e-10);
        CHECK(std::fabs(rig.angular_momentum()) < 1e-4);
    }
}

TEST_CASE("self-contact gives no energy away for free", "[dynamics][self_contact]") {
    const BodyPlan plan = clapper();
    const auto scene = make_scene(plan, empty_space());
    for (int tick = 0; tick < 600; ++tick) {
        const double swing = 1.4 * sine(3.0 * scene->time());
        scene->set_target(1, -swing);
        scene->set_target(2, swing);
        REQUIRE(scene->advance(kTestTick) == SceneStatus::kRunning);
    }
    const SceneAudit& audit = scene->audit();
    CHECK(audit.positive_work < 0.02 * audit.gross_motor_work);
    CHECK(std::fabs(audit.energy_residual) < 0.02 * audit.gross_motor_work);
}

TEST_CASE("the list of pairs finds the contacts of all pairs in their order",
          "[dynamics][contact]") {
    RandomStream random(stream_seed({77}));
    int touching = 0;
    for (int round = 0; round < 40; ++round) {
        const PlanarModel one = *build_planar_model(random_tree(random, 14, 0.3, 1.0, 1.0), 1.0);
        const PlanarModel* const two[] = {&one, &one};
        const PlanarModel model = round % 2 == 0 ? one : join_models(two);
        PairList list;
        list.forget();
        Motion motion = random_motion(random, model);
        for (int moment = 0; moment < 20; ++moment) {
            for (int c = 0; c < coordinate_count(model); ++c)
                motion.position[c] += 0.03 * random.gauss();
            Kinematics kinematics;
            compute_kinematics(model, motion, kinematics);
            PartPlaces places;
            place_parts(model, kinematics, places);
            ContactSet contacts;
            contacts.most = kMaxContacts;
            list.detect(model, kinematics, places, contacts);
            if (contacts.count == kMaxContacts) continue;  // some were dropped
            int at = 0;
            for (std::size_t i = 0; i < model.colliding_pairs.size(); ++i) {
                const PartPair pair = model.colliding_pairs[i];
                const BoxManifold points =
                    collide_boxes(placed_box(places, pair.first), placed_box(places, pair.second),
                                  kContactMargin);
                for (int point = 0; point < points.count; ++point, ++at) {
                    REQUIRE(at < contacts.count);
                    const int id = kGroundContactIds + kIdsPerPair * static_cast<int>(i) +
                                   (points.first_is_incident ? 4 : 0) + points.corner[point];
                    REQUIRE(contacts.items[at].id == id);
                    REQUIRE(contacts.items[at].gap == points.gap[point]);
                }
            }
            REQUIRE(contacts.count == at);
            touching += at;
        }
    }
    CHECK(touching > 400);
}

// The second model has one pair, in a group whose other lanes are no pairs.
TEST_CASE("positions that are not numbers touch in no more pairs than there are",
          "[dynamics][contact]") {
    PairList list;
    for (const bool is_diverged : {false, true}) {
        const PlanarModel model = *build_planar_model(is_diverged ? clapper() : chain(8, 1.0), 1.0);
        REQUIRE(
            (is_diverged ? model.colliding_pairs.size() == 1 : model.colliding_pairs.size() > 4));
        Kinematics kinematics;
        compute_kinematics(model, rest_motion(model), kinematics);
        PartPlaces places;
        place_parts(model, kinematics, places);
        ContactSet contacts;
        list.forget();
        list.detect(model, kinematics, places, contacts);
        if (!is_diverged) continue;
        for (int part = 0; part < round_up_to_lanes(model.part_count); ++part)
            places.x[part] = std::numeric_limits<double>::quiet_NaN();
        contacts.count = 0;
        list.detect(model, kinematics, places, contacts);
        CHECK(contacts.count <= 2);
    }
}
