#pragma once

// The light of a trial's world and how it moves (simulator/README.md 5).

#include "core/random.h"
#include "simulator/settings/trial_settings.h"
#include "world/environment.h"
#include "world/surroundings.h"

#include <cstdint>

namespace cambrian {

// The random draw that determines the places of a moving light.
struct LightDraw {
    std::uint64_t seed = 0;
    int trial = 0;  // index of the trial; trials 2n and 2n + 1 are mirror images

    friend bool operator==(const LightDraw&, const LightDraw&) = default;
};

class LightSource {
public:
    LightSource(const Environment& environment, const LightDraw& draw);

    // Applies an edit by the user. A changed position restarts the light there.
    void set_environment(const Environment& environment);
    // Must be called before each tick of the test phase, numbered from 0, with the creature's
    // centre of mass, from which the distance of a jump is measured, and its length so far in m,
    // the unit of that distance.
    void move(std::uint64_t tick, const Vec3& center, double length);

    bool is_on() const { return environment_.has_light; }
    // Returns whether the light may move during the trial.
    bool moves() const;
    // Returns the time between two jumps in ticks, at least 1.
    std::uint64_t leg_ticks() const;
    const Vec3& place() const { return moment_.place; }
    Light at(const Vec3& point) const;

    // The data that change from tick to tick.
    struct Moment {
        Vec3 place = Vec3::Zero();     // m
        Vec3 velocity = Vec3::Zero();  // m/s, of a wandering light
        double distance = 0.0;         // m from the creature, of the last jump
        RandomStream noise;
    };
    const Moment& save() const { return moment_; }
    void restore(const Moment& moment) { moment_ = moment; }

private:
    void jump(std::uint64_t leg, const Vec3& center, double length);
    void follow(const Vec3& center);
    void wander();

    Environment environment_;
    LightDraw draw_;
    Moment moment_;
};

}  // namespace cambrian
