#include "sensors/sensor.h"

#include "creature/fake_scene.h"
#include "sensors/fake_surroundings.h"
#include "support/catch.h"

#include <cmath>

using namespace cambrian;

namespace {

const SensorRegistry& sensors() {
    static const SensorRegistry all = builtin_sensors();
    return all;
}

double read(const FakeScene& scene, std::size_t kind, std::size_t channel, int handedness) {
    const FakeSurroundings surroundings;
    const PlannedPart part;
    double memory = 0.0;
    return sensors()[kind].read({scene, surroundings, part, 0, channel, {handedness}}, memory);
}

// A single part whose readings are compared with a table.
struct Bench {
    FakeScene scene{1};
    FakeSurroundings surroundings;
    PlannedPart part;
    int handedness = 1;
    double memory = 0.0;

    void turn(double angle) { scene.poses[0] = planar_pose(0.3, 0.7, angle); }
    double read(std::string_view channel_id, double share = 0.2) {
        for (const SensorKind& kind : sensors().all()) {
            for (std::size_t channel = 0; channel < kind.channels.size(); ++channel) {
                if (kind.channels[channel].id == channel_id)
                    return kind.read({scene, surroundings, part, 0, channel, {handedness}, share},
                                     memory);
            }
        }
        FAIL("no channel " << channel_id);
        return 0.0;
    }
    // Returns the reading after a long time in the same state.
    double read_at_last(std::string_view channel_id) {
        for (int tick = 0; tick < 200; ++tick)
            read(channel_id);
        return read(channel_id);
    }
};

// A direction of a part's axis with its cosine and sine.
struct Direction {
    double angle, cosine, sine;
};
const double kHalf = std::sqrt(0.5);
const std::array kDirections = {
    Direction{0.0, 1.0, 0.0},         Direction{0.25 * kPi, kHalf, kHalf},
    Direction{0.5 * kPi, 0.0, 1.0},   Direction{0.75 * kPi, -kHalf, kHalf},
    Direction{kPi, -1.0, 0.0},        Direction{-0.75 * kPi, -kHalf, -kHalf},
    Direction{-0.5 * kPi, 0.0, -1.0}, Direction{-0.25 * kPi, kHalf, -kHalf}};

}  // namespace

TEST_CASE("channels have the absolute numbers genes rely on", "[sensors]") {
    std::vector<std::string> channels;
    for (const SensorKind& sensor : sensors().all()) {
        for (const SensorChannel& channel : sensor.channels)
            channels.push_back(channel.id);
    }
    CHECK(channels ==
          std::vector<std::string>{
              "joint",          "contact-distal", "contact-left",     "contact-proximal",
              "contact-right",  "accel-along",    "accel-across",     "joint-rate",
              "effort",         "spin",           "up-along",         "up-across",
              "load",           "light-along",    "light-across",     "light",
              "sound-1",        "sound-2",        "sound-3",          "sound-4",
              "smell",          "stretch",        "stretch-rate",     "smell-food",
              "smell-flesh",    "energy",         "obstacle-left",    "obstacle-right",
              "whisker-distal", "whisker-left",   "whisker-proximal", "whisker-right",
              "ground-left",    "ground-right"});
}

TEST_CASE("only joint and contact sensors are used unless settings say otherwise", "[sensors]") {
    for (const SensorKind& sensor : sensors().all()) {
        INFO(sensor.id);
        CHECK(sensor.usual == (sensor.id == "joint" || sensor.id == "contact"));
    }
}

TEST_CASE("the joint sensor reads the coordinate, turned round on mirrored parts", "[sensors]") {
    FakeScene scene(1);
    scene.coordinates[0] = 0.7;
    CHECK(read(scene, 0, 0, 1) == 0.7);
    CHECK(read(scene, 0, 0, -1) == -0.7);
}

TEST_CASE("each contact channel reads its own face, sides exchanged on mirrored parts",
          "[sensors]") {
    constexpr std::array<std::size_t, 4> mirrored = {0, 3, 2, 1};
    for (std::size_t face = 0; face < mirrored.size(); ++face) {
        FakeScene scene(1);
        scene.touched[0][face] = true;
        for (std::size_t channel = 0; channel < mirrored.size(); ++channel) {
            CHECK(read(scene, 1, channel, 1) == (channel == face ? 1.0 : -1.0));
            CHECK(read(scene, 1, channel, -1) == (mirrored[channel] == face ? 1.0 : -1.0));
        }
    }
}

TEST_CASE("balance reads where up is, in eight directions of the part", "[sensors]") {
    for (const Direction& direction : kDirections) {
        Bench bench;
        bench.turn(direction.angle);
        INFO("angle " << direction.angle);
        CHECK(bench.read("up-along") == Approx(direction.sine).margin(1e-12));
        CHECK(bench.read("up-across") == Approx(direction.cosine).margin(1e-12));
        bench.handedness = -1;
        CHECK(bench.read("up-along") == Approx(direction.sine).margin(1e-12));
        CHECK(bench.read("up-across") == Approx(-direction.cosine).margin(1e-12));
        bench.surroundings.upwards = Vec3::Zero();
        CHECK(bench.read("up-along") == 0.0);
        CHECK(bench.read("up-across") == 0.0);
    }
}

TEST_CASE("the accelerometer reads the specific force in the part's frame", "[sensors]") {
    for (const Direction& direction : kDirections) {
        INFO("angle " << direction.angle);
        for (const int handedness : {1, -1}) {
            Bench bench;
            bench.turn(direction.angle);
            bench.handedness = handedness;
            bench.scene.specific_forces[0] = {0.0, 2.0 * 9.81, 0.0};
            CHECK(bench.read_at_last("accel-along") == Approx(2.0 * direction.sine).margin(1e-9));
            CHECK(bench.read_at_last("accel-across") ==
                  Approx(2.0 * handedness * direction.cosine).margin(1e-9));
        }
    }
}

TEST_CASE("the accelerometer approaches what it feels and is limited", "[sensors]") {
    CHECK(sensors().find("accelerometer")->time_constant == 0.05);
    Bench bench;
    bench.scene.specific_forces[0] = {9.81, 0.0, 0.0};
    CHECK(bench.read("accel-along", 0.25) == Approx(0.25));
    CHECK(bench.read("accel-along", 0.25) == Approx(0.4375));
    const double before = bench.memory;
    CHECK(bench.read("accel-along", 0.0) == before);
    bench.scene.specific_forces[0] = {-1e6, 0.0, 0.0};
    CHECK(bench.read_at_last("accel-along") == Approx(-10.0));
}

TEST_CASE("rates read 1 at 6 rad/s or 1.5 lengths a second", "[sensors]") {
    Bench bench;
    bench.part.motion = JointMotion::kTurn;
    bench.part.half_extents = {0.4, 0.1, 0.0};
    bench.scene.rates[0] = 3.0;
    bench.scene.twists[0].angular.z() = -1.5;
    CHECK(bench.read("joint-rate") == Approx(0.5));
    CHECK(bench.read("spin") == Approx(-0.25));
    bench.handedness = -1;
    CHECK(bench.read("joint-rate") == Approx(-0.5));
    CHECK(bench.read("spin") == Approx(0.25));
    bench.part.motion = JointMotion::kSlide;
    bench.scene.rates[0] = 0.6;
    CHECK(bench.read("joint-rate") == Approx(0.5));
    bench.scene.rates[0] = -1e3;
    CHECK(bench.read("joint-rate") == -10.0);
}

TEST_CASE("effort reads the share of the muscle's most", "[sensors]") {
    Bench bench;
    bench.scene.efforts[0] = -0.5;
    CHECK(bench.read("effort") == 0.0);
    bench.part.motion = JointMotion::kTurn;
    bench.part.max_effort = 2.0;
    CHECK(bench.read("effort") == -0.25);
    bench.handedness = -1;
    CHECK(bench.read("effort") == 0.25);
    bench.part.motion = JointMotion::kSlide;
    CHECK(bench.read("effort") == -0.25);
    bench.scene.efforts[0] = 5.0;
    CHECK(bench.read("effort") == 1.0);
}

TEST_CASE("load reads normal forces in units of the creature's weight", "[sensors]") {
    Bench bench;
    CHECK(bench.read("load") == 0.0);
    bench.scene.loads[0] = 0.5 * 9.81;  // for a creature of 1 kg
    CHECK(bench.read("load") == Approx(0.5));
    bench.scene.loads[0] = 1e4;
    CHECK(bench.read("load") == 10.0);
}

TEST_CASE("a part feels how far and how fast it is stretched, whether mirrored or not",
          "[sensors]") {
    Bench bench;
    bench.scene.stretches[0] = -0.25;
    bench.scene.stretch_rates[0] = 0.75;
    for (const int handedness : {1, -1}) {
        bench.handedness = handedness;
        CHECK(bench.read("stretch") == -0.5);
        CHECK(bench.read("stretch-rate") == 0.5);
    }
}

TEST_CASE("every lamp of a sensor is on its part", "[sensors]") {
    for (const SensorKind& kind : sensors().all()) {
        if (kind.spot == nullptr) continue;
        for (std::size_t channel = 0; channel < kind.channels.size(); ++channel) {
            INFO(kind.channels[channel].id);
            const Vec3 spot = kind.spot(channel, 1);
            CHECK(spot.cwiseAbs().maxCoeff() < 1.0);
            CHECK(kind.spot(channel, -1).x() == spot.x());
            CHECK(kind.spot(channel, -1).y() == -spot.y());
        }
    }
}

TEST_CASE("light is read as its direction in the part's frame, in eight directions of the part",
          "[sensors][light]") {
    for (const Direction& direction : kDirections) {
        Bench bench;
        bench.turn(direction.angle);
        bench.surroundings.lit = {Vec3(0.6, 0.8, 0.0), 0.25};
        INFO("angle " << direction.angle);
        const double along = 0.6 * direction.cosine + 0.8 * direction.sine;
        const double across = 0.8 * direction.cosine - 0.6 * direction.sine;
        for (const int handedness : {1, -1}) {
            bench.handedness = handedness;
            CHECK(bench.read("light-along") == Approx(along).margin(1e-12));
            CHECK(bench.read("light-across") == Approx(handedness * across).margin(1e-12));
            CHECK(bench.read("light") == 0.25);
        }
    }
}

TEST_CASE("in the dark light reads 0, and more than signals hold is limited", "[sensors][light]") {
    Bench bench;
    for (const char* channel : {"light-along", "light-across", "light"})
        CHECK(bench.read(channel) == 0.0);
    bench.surroundings.lit = {Vec3::UnitX(), 50.0};
    CHECK(bench.read("light") == 10.0);
}

TEST_CASE("each ear reads its own band, limited like all signals", "[sensors][sound]") {
    Bench bench;
    bench.surroundings.loudness = {0.1, 0.2, 0.4, 50.0};
    for (const int handedness : {1, -1}) {
        bench.handedness = handedness;
        CHECK(bench.read("sound-1") == 0.1);
        CHECK(bench.read("sound-2") == 0.2);
        CHECK(bench.read("sound-3") == 0.4);
        CHECK(bench.read("sound-4") == 10.0);
    }
}

TEST_CASE("the nose is at the far end and reads the logarithm of the scent", "[sensors][smell]") {
    for (const Direction& direction : kDirections) {
        Bench bench;
        bench.turn(direction.angle);
        bench.scene.half_extents[0] = Vec3(0.4, 0.1, 0.0);
        struct Row {
            double scent, reading;
        };
        for (const Row& row : {Row{0.0, 0.0}, Row{0.001, 0.25 * std::log(2.0)},
                               Row{0.001 * (std::exp(4.0) - 1.0), 1.0}, Row{1e30, 5.0}}) {
            bench.surroundings.concentration = row.scent;
            CHECK(bench.read("smell") == Approx(row.reading).margin(1e-12));
        }
        const Vec3 nose(0.3 + 0.4 * direction.cosine, 0.7 + 0.4 * direction.sine, 0.0);
        CHECK((bench.surroundings.scented - nose).norm() < 1e-12);
    }
}

TEST_CASE("noses for plants and flesh read as the one for scent", "[sensors][smell]") {
    Bench bench;
    bench.surroundings.plants = 0.001;
    bench.surroundings.flesh = 0.001 * (std::exp(4.0) - 1.0);
    CHECK(bench.read("smell-food") == Approx(0.25 * std::log(2.0)));
    CHECK(bench.read("smell-flesh") == Approx(1.0));
    CHECK(bench.read("smell") == 0.0);
}

TEST_CASE("each whisker feels out of its own face, sides exchanged on mirrored parts",
          "[sensors][whisker]") {
    struct Row {
        double angle;
        int handedness;
        const char* whisker;  // that points to the left
        Vec3 face;
    };
    for (const Row& row : {Row{0.0, 1, "whisker-proximal", {-0.1, 0.7, 0.0}},
                           Row{kPi, 1, "whisker-distal", {-0.1, 0.7, 0.0}},
                           Row{0.5 * kPi, 1, "whisker-left", {0.2, 0.7, 0.0}},
                           Row{0.5 * kPi, -1, "whisker-right", {0.2, 0.7, 0.0}},
                           Row{-0.5 * kPi, 1, "whisker-right", {0.2, 0.7, 0.0}},
                           Row{-0.5 * kPi, -1, "whisker-left", {0.2, 0.7, 0.0}}}) {
        Bench bench;
        bench.turn(row.angle);
        bench.handedness = row.handedness;
        bench.scene.half_extents[0] = Vec3(0.4, 0.1, 0.0);
        for (const char* whisker :
             {"whisker-distal", "whisker-left", "whisker-proximal", "whisker-right"}) {
            const bool points_left = std::string(whisker) == row.whisker;
            CHECK(bench.read(whisker) == Approx(points_left ? 0.6 : 0.0));
            if (points_left) CHECK((bench.surroundings.felt - row.face).norm() < 1e-12);
        }
        bench.surroundings.to_the_left = 1.5;
        CHECK(bench.read(row.whisker) == 0.0);
    }
}

TEST_CASE("the height of the ground is that beside the part above that below it",
          "[sensors][whisker]") {
    Bench bench;
    CHECK(bench.read("ground-right") == Approx(0.2));  // 5 cm of 25
    CHECK(bench.read("ground-left") == Approx(-0.2));
    bench.handedness = -1;
    CHECK(bench.read("ground-right") == Approx(-0.2));
    bench.surroundings.slope = -9.0;
    CHECK(bench.read("ground-right") == 1.0);
    CHECK(bench.read("ground-left") == -1.0);
}

TEST_CASE("hunger reads the store as a share of that at birth, up to 4", "[sensors]") {
    Bench bench;
    CHECK(bench.read("energy") == 0.0);
    bench.surroundings.store = 0.25;
    CHECK(bench.read("energy") == 0.25);
    bench.surroundings.store = 9.0;
    CHECK(bench.read("energy") == 4.0);
}
