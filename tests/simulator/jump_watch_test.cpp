#include "simulator/jump_watch.h"

#include "simulator/settings/trial_settings.h"
#include "support/catch.h"

#include <functional>

using namespace cambrian;

namespace {

// Heights of the lowest point and of the centre of mass at a time (s), in metres.
struct Heights {
    double lowest = 0.0;
    double center = 0.0;
};

JumpWatch watched(double duration, const std::function<Heights(double)>& motion) {
    JumpWatch jumps;
    for (int tick = 0; tick * kBrainTick <= duration; ++tick) {
        const Heights now = motion(tick * kBrainTick);
        jumps.watch(now.lowest, now.center);
    }
    return jumps;
}

// Returns the height of a body thrown upwards with a speed.
double ballistic(double time, double speed, double gravity = 9.81) {
    return time > 0.0 ? std::max(0.0, speed * time - 0.5 * gravity * time * time) : 0.0;
}

}  // namespace

TEST_CASE("a ballistic jump is as high as v^2 / 2g", "[simulator][jump_watch]") {
    const JumpWatch jumps = watched(3.0, [](double t) {
        const double height = ballistic(t - 1.0, 3.0);
        return Heights{height, 0.4 + height};
    });
    CHECK(jumps.best().height == Approx(9.0 / (2.0 * 9.81)).epsilon(0.002));
    CHECK(jumps.best().clearance == jumps.best().height);
    CHECK(jumps.best().take_off_speed == Approx(3.0).epsilon(0.05));
    CHECK(jumps.upward_speed() == Approx(3.0 - 0.05 * 9.81).epsilon(0.02));
}

TEST_CASE("feet pulled up in a fall are no jump", "[simulator][jump_watch]") {
    const JumpWatch jumps = watched(3.0, [](double t) {
        const double fallen = t > 1.0 ? std::min(0.3, 4.9 * (t - 1.0) * (t - 1.0)) : 0.0;
        return Heights{fallen > 0.0 && fallen < 0.3 ? 0.2 : 0.0, 0.5 - fallen};
    });
    CHECK(jumps.best().height == 0.0);
    CHECK(jumps.upward_speed() == 0.0);
}

TEST_CASE("getting up is no jump", "[simulator][jump_watch]") {
    const JumpWatch jumps = watched(3.0, [](double t) {
        return Heights{0.005, 0.2 + 0.6 * std::min(t, 1.0)};
    });
    CHECK(jumps.best().height == 0.0);
    CHECK(jumps.upward_speed() == Approx(0.6));
}

TEST_CASE("what the push adds before take-off is not part of a jump", "[simulator][jump_watch]") {
    const JumpWatch jumps = watched(3.0, [](double t) {
        const double pushed = std::min(0.3, 2.0 * t);  // m, at 2 m/s
        const double flown = ballistic(t - 0.15, 2.0);
        return Heights{flown, 0.4 + pushed + flown};
    });
    CHECK(jumps.best().rise == Approx(4.0 / (2.0 * 9.81)).margin(2.0 / 60.0));
}

TEST_CASE("a bounce after a fall that took long is measured from where the fall began",
          "[simulator][jump_watch]") {
    const auto drop_and_bounce = [](double rest) {
        return watched(10.0, [rest](double t) {
            if (t < 1.0) return Heights{0.0, 1.5};
            if (t < 3.0) return Heights{0.5, 1.5 - 0.5 * (t - 1.0)};  // feet up, falling slowly
            const double bounced = ballistic(t - 3.0 - rest, 1.0, 1.62);
            return Heights{bounced, 0.5 + bounced};
        });
    };
    CHECK(drop_and_bounce(0.2).best().height == 0.0);
    CHECK(drop_and_bounce(1.5).best().height == Approx(1.0 / 3.24).epsilon(0.01));
}

TEST_CASE("where a trial begins counts as a stance, even in the air", "[simulator][jump_watch]") {
    const JumpWatch jumps = watched(1.0, [](double t) { return Heights{0.02 + 0.1 * t, 1.0}; });
    CHECK(jumps.best().height == 0.0);
}
