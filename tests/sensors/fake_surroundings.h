#pragma once

#include "world/emissions.h"
#include "world/surroundings.h"

#include <array>
#include <limits>

namespace cambrian {

// Surroundings with values that a test sets, the same everywhere.
class FakeSurroundings final : public Surroundings {
public:
    Vec3 up() const override { return upwards; }
    Light light(const Vec3& /*point*/) const override { return lit; }

    double sound(const Vec3& /*point*/, int band) const override {
        return loudness[static_cast<std::size_t>(band)];
    }
    double scent(const Vec3& point) const override {
        scented = point;
        return concentration;
    }

    double distance_to_ground(const Vec3& from, const Vec3& direction,
                              double reach) const override {
        felt = from;
        return direction.x() < -0.99 && to_the_left <= reach
                   ? to_the_left
                   : std::numeric_limits<double>::infinity();
    }
    double ground_height(double x) const override { return slope * x; }

    double plant_smell(const Vec3& /*point*/) const override { return plants; }
    double flesh_smell(const Vec3& /*point*/) const override { return flesh; }
    double energy() const override { return store; }

    Vec3 upwards = Vec3::UnitY();
    Light lit;
    std::array<double, kSoundBands> loudness = {};
    double concentration = 0.0;
    double plants = 0.0, flesh = 0.0;
    double store = 0.0;
    double to_the_left = 0.4;          // m, to the ground in the direction of -x; elsewhere is none
    double slope = 0.1;                // of the ground
    mutable Vec3 felt = Vec3::Zero();  // from where the distance to ground was last asked for
    mutable Vec3 scented = Vec3::Zero();  // where scent was last asked for
};

}  // namespace cambrian
