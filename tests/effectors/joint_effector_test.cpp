#include "creature/fake_scene.h"
#include "effectors/effector.h"
#include "support/catch.h"

#include <cmath>

using namespace cambrian;

namespace {

struct Muscle {
    PlannedPart part;
    SceneSettings settings;
    FakeScene scene{2};
    double memory = 0.0;

    double drive(double signal, double dt) {
        static const EffectorRegistry effectors = builtin_effectors();
        const double share = smoothing_share(dt, settings.target_smoothing);
        effectors[0].drive({part, {1, 0}}, signal, share, settings, memory, scene);
        return scene.targets[1];
    }
};

Muscle muscle() {
    Muscle made;
    made.part.limit_low = -0.5;
    made.part.limit_high = 1.5;
    return made;
}

}  // namespace

TEST_CASE("the target is held to the limits before it is smoothed", "[effectors]") {
    Muscle strained = muscle();
    Muscle exact = muscle();
    for (int tick = 0; tick < 30; ++tick)
        REQUIRE(strained.drive(10.0, 1.0 / 60.0) == exact.drive(1.5, 1.0 / 60.0));
    CHECK(exact.memory == Approx(1.5 * (1.0 - std::exp(-5.0))));
}

TEST_CASE("smoothing does not depend on the length of the tick", "[effectors]") {
    Muscle coarse = muscle();
    Muscle fine = muscle();
    coarse.drive(1.0, 0.1);
    for (int tick = 0; tick < 10; ++tick)
        fine.drive(1.0, 0.01);
    CHECK(coarse.memory == Approx(fine.memory));
}

TEST_CASE("without smoothing the target is reached at once", "[effectors]") {
    Muscle quick = muscle();
    quick.settings.target_smoothing = 0.0;
    CHECK(quick.drive(-3.0, 1.0 / 60.0) == -0.5);
}

TEST_CASE("in torque mode the signal is a share of the greatest effort", "[effectors]") {
    Muscle torque = muscle();
    torque.part.motor_mode = MotorMode::kTorque;
    torque.settings.target_smoothing = 0.0;
    CHECK(torque.drive(1.5707963267948966, 1.0) == Approx(0.5));
    CHECK(torque.drive(-10.0, 1.0) == -1.0);
}
