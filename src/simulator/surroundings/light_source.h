#pragma once

// The light of a trial's world and how it moves (simulator/README.md 5).

#include "core/random.h"
#include "simulator/settings/trial_settings.h"
#include "world/environment.h"
#include "world/surroundings.h"

#include <cstdint>

namespace cambrian {

// What the places of a moving light follow from, besides the environment.
struct LightDraw {
    std::uint64_t seed = 0;
    int trial = 0;  // of the experiment's trials; trials 2n and 2n + 1 are mirror images

    friend bool operator==(const LightDraw&, const LightDraw&) = default;
};

inline constexpr double kLegTime = 5.0;  // s, from one jump to the next
inline constexpr auto kLegTicks = static_cast<std::uint64_t>(kLegTime / kBrainTick + 0.5);

class LightSource {
public:
    // Jumps are as far as 3 to 6 times the body's length at rest (m).
    LightSource(const Environment& environment, const LightDraw& draw, double rest_length);

    // A change by hand; a light that was moved begins where it was put.
    void set_environment(const Environment& environment);
    // Once before each tick of the test, numbered from 0. The creature's centre of mass is where
    // jumps begin.
    void move(std::uint64_t tick, const Vec3& center);

    bool is_on() const { return environment_.has_light; }
    // Whether it may be somewhere else later.
    bool moves() const;
    const Vec3& place() const { return moment_.place; }
    Light at(const Vec3& point) const;

    // What changes from tick to tick.
    struct Moment {
        Vec3 place = Vec3::Zero();     // m
        Vec3 velocity = Vec3::Zero();  // m/s, of one that wanders
        RandomStream noise;
    };
    const Moment& save() const { return moment_; }
    void restore(const Moment& moment) { moment_ = moment; }

private:
    void jump(std::uint64_t leg, const Vec3& center);
    void wander();

    Environment environment_;
    LightDraw draw_;
    double rest_length_;
    Moment moment_;
};

}  // namespace cambrian
