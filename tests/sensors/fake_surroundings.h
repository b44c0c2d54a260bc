#pragma once

#include "world/emissions.h"
#include "world/surroundings.h"

#include <array>

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

    double plant_smell(const Vec3& /*point*/) const override { return plants; }
    double flesh_smell(const Vec3& /*point*/) const override { return flesh; }
    double energy() const override { return store; }

    Vec3 upwards = Vec3::UnitY();
    Light lit;
    std::array<double, kSoundBands> loudness = {};
    double concentration = 0.0;
    double plants = 0.0, flesh = 0.0;
    double store = 0.0;
    mutable Vec3 scented = Vec3::Zero();  // where scent was last asked for
};

}  // namespace cambrian
