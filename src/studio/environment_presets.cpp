#include "studio/environment_presets.h"

#include <array>

namespace cambrian {
namespace {

Environment on_land(double gravity, double friction, const Environment& present) {
    Environment world;
    world.gravity = gravity;
    world.friction = friction;
    world.density = present.density;
    return world;
}

Environment in_fluid(double linear, double quadratic, const Environment& present) {
    Environment world;
    world.gravity = 0.0;
    world.has_ground = false;
    world.viscosity_linear = linear;
    world.viscosity_quadratic = quadratic;
    world.density = present.density;
    return world;
}

constexpr double kEarthGravity = 9.81;  // m/s^2
constexpr double kMoonGravity = 1.62;

constexpr std::array kPresets = {
    EnvironmentPreset{"Earth", "Solid ground under full weight.",
                      [](Environment e) { return on_land(kEarthGravity, 0.8, e); }},
    EnvironmentPreset{"Moon", "A sixth of the weight.",
                      [](Environment e) { return on_land(kMoonGravity, 0.8, e); }},
    EnvironmentPreset{"Ice", "Full weight with hardly any grip.",
                      [](Environment e) { return on_land(kEarthGravity, 0.05, e); }},
    EnvironmentPreset{"Water", "Weightless; drag grows with the square of the speed, as for swimmers.",
                      [](Environment e) { return in_fluid(0.2, 1.0, e); }},
    EnvironmentPreset{"Treacle", "Weightless; drag grows with the speed, nothing glides.",
                      [](Environment e) { return in_fluid(8.0, 0.0, e); }},
    EnvironmentPreset{"Zero-g tank", "Weightless in a thin medium.",
                      [](Environment e) { return in_fluid(0.2, 0.1, e); }},
};

}  // namespace

std::span<const EnvironmentPreset> environment_presets() {
    return kPresets;
}

}  // namespace cambrian
